// Project files: what was read is written and read again, the same.
#include "core/qt/document/project/project_file.h"
#include "tests/fuzz/fuzz.h"

using namespace ramure;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto bytes =
        QByteArray::fromRawData(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
    const auto project = readProject(bytes, QStringLiteral("fuzz.ramure"));
    if (!project) {
        fuzz::claimGoodError(project.error());
        return 0;
    }
    const QByteArray written = writeProject(*project);
    const auto again = readProject(written, QStringLiteral("again.ramure"));
    fuzz::claim(again.has_value(), "what was written can be read");
    fuzz::claim(writeProject(*again) == written, "a second writing gives the same bytes");
    return 0;
}
