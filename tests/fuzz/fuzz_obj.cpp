#include "core/io/mesh_file.h"
#include "tests/fuzz/fuzz.h"

using namespace ramure;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto mesh = parseObj(fuzz::textOf(data, size), "fuzz.obj");
    if (!mesh) {
        fuzz::claimGoodError(mesh.error());
        return 0;
    }
    fuzz::claim(!mesh->objects.empty(), "there is an object");
    for (const ReadObject& object : mesh->objects)
        fuzz::claimGoodMesh(object.mesh);
    fuzz::claimGoodMesh(mesh->joined());
    return 0;
}
