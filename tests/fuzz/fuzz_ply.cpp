// PLY: as bytes in memory, and as a file.
#include "core/io/read_parts.h"
#include "tests/fuzz/fuzz.h"

using namespace ramure;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const fuzz::MemoryFile file(data, size);
    const auto mesh = parsePly(fuzz::textOf(data, size), file.path());
    fuzz::claimSame(mesh, reading::readPlyFile(file.path(), {}));
    if (!mesh) {
        fuzz::claimGoodError(mesh.error());
        return 0;
    }
    fuzz::claim(mesh->objects.size() == 1, "there is one object");
    fuzz::claimGoodMesh(mesh->objects.front().mesh);
    return 0;
}
