#include "core/io/formats/file_format.h"
#include "core/io/formats/text/blender_scene.h"

namespace ramure {

extern const FileFormat animationFormat;
const FileFormat animationFormat = {
    .id = "animation",
    .ending = "animation",
    .name = RAMURE_NOOP("Keys from Blender"),
    .import = &importBlender,
};

} // namespace ramure
