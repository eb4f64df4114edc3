/// \file
/// Disks that refuse to write, and what has to be true of every writer then.
#pragma once

#include "core/base/error.h"
#include <QMap>
#include <QString>
#include <functional>
#include <sys/resource.h>

namespace ramure::test {

/// While it lives one call of the system that core/base/file_writer.h makes fails. The others do their work,
/// without waiting for the disk.
class FailingDisk
{
public:
    /// \param call 1 = the first that is made. \param reason its errno.
    FailingDisk(int call, int reason);
    ~FailingDisk();
    FailingDisk(const FailingDisk&) = delete;
    FailingDisk& operator=(const FailingDisk&) = delete;
    [[nodiscard]] bool hasFailed() const; ///< false: there were not so many calls
};

/// Lets no file grow beyond a size, as a full disk does.
class SmallDisk
{
public:
    explicit SmallDisk(rlim_t bytes);
    ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

private:
    rlimit m_before{};
};

/// All files of a folder, hidden ones too: what is in them, by their names.
QMap<QString, QByteArray> filesIn(const QString& folder);

/// Writes into a folder; \p version 0 and 1 give files of the same names with other bytes.
using WriteFiles = std::function<Expected<void>(const QString& folder, int version)>;

/// Fails the running test unless this holds for the first, second ... last call of the system that \p write
/// makes, where there are old files and where there are none, and for a disk that is full: when the call
/// fails, \p write gives an error with file and reason, the old files are what they were, and there is no
/// other file.
/// \param single false: every file stands for itself; those written before the error are whole and stay.
void checkNothingLost(const WriteFiles& write, bool single = true);

} // namespace ramure::test
