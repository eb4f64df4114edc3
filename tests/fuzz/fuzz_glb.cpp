// GLB: as meshes and as a scene.
#include "core/io/formats/glb/glb_reader.h"
#include "tests/fuzz/fuzz.h"

using namespace ramure;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const fuzz::MemoryFile file(data, size);
    fuzz::claimGoodReading(readGlb(file.path(), {}), importGlb(file.path(), {}, {}));
    return 0;
}
