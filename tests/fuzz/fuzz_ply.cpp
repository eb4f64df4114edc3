#include "core/io/mesh_file.h"
#include "tests/fuzz/fuzz.h"

using namespace ramure;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto mesh = parsePly(fuzz::textOf(data, size), "fuzz.ply");
    if (!mesh) {
        fuzz::claimGoodError(mesh.error());
        return 0;
    }
    fuzz::claim(mesh->objects.size() == 1, "there is one object");
    fuzz::claimGoodMesh(mesh->objects.front().mesh);
    return 0;
}
