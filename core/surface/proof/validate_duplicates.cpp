#include "core/surface/mesh/duplicate_positions.h"
#include "core/surface/proof/validate_parts.h"

namespace ramure::validation {

void findDuplicateVertices(std::span<const glm::vec3> positions, DefectLog& log)
{
    for (const DuplicatePosition& found : findDuplicatePositions(positions))
        log.add(DefectKind::DuplicateVertex, found.vertex, found.earlier);
}

} // namespace ramure::validation
