#include "core/io/formats/blender_scene.h"
#include "core/io/formats/file_format.h"

namespace ramure {

extern const FileFormat animationFormat;
const FileFormat animationFormat = {
    .id = "animation",
    .ending = "animation",
    .name = RAMURE_NOOP("Keys from Blender"),
    .import = &importBlender,
};

} // namespace ramure
