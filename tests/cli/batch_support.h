/// \file
/// Batches for suites: small tables, and what stands in the folder afterwards.
#pragma once

#include "tests/cli/cli_support.h"
#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <map>
#include <set>
#include <vector>

namespace ramure::test {

/// A table of small trees, with seeds from 1.
inline QByteArray smallTrees(int rows)
{
    QByteArray text = "preset,seed,sections.radialDivisions\n";
    for (int i = 1; i <= rows; ++i)
        text += "TinyTree," + QByteArray::number(i) + ",4\n";
    return text;
}

inline QStringList batchOf(const QString& table, const QString& folder, const QStringList& more = {})
{
    return QStringList{"batch", table, "-o", folder, "--file", "{preset}_{seed}.obj", "--jobs", "2"} + more;
}

/// All files below a folder, by their names; hidden ones too.
inline std::map<QString, QByteArray> filesBelow(const QString& folder)
{
    std::map<QString, QByteArray> files;
    for (QDirIterator it(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories); it.hasNext();) {
        const QString path = it.next();
        files[path.mid(folder.size() + 1)] = bytesOf(path);
    }
    return files;
}

/// The objects of a manifest, in the order of its lines.
inline std::vector<QJsonObject> linesOf(const QString& manifest)
{
    std::vector<QJsonObject> lines;
    for (const QByteArray& line : bytesOf(manifest).split('\n'))
        if (!line.isEmpty())
            lines.push_back(QJsonDocument::fromJson(line).object());
    return lines;
}

} // namespace ramure::test
