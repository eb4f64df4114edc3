// OBJ text: as a whole, and as a file in small blocks.
#include "core/io/read_parts.h"
#include "tests/fuzz/fuzz.h"

using namespace ramure;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const fuzz::MemoryFile file(data, size);
    // The text is its own material file as well.
    const MaterialSource materials = [text = std::string(fuzz::textOf(data, size))](const std::string&) {
        return Expected<std::string>(text);
    };
    const auto mesh = parseObj(fuzz::textOf(data, size), file.path(), {}, materials);
    const std::size_t blockSize = size % 3 == 0 ? reading::lineBlockSize : 1 + size % 61;
    fuzz::claimSame(mesh, reading::readObjFile(file.path(), {}, materials, blockSize));
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
