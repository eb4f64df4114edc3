#include "core/io/formats/glb/glb_shapes.h"

namespace ramure::glb {

void addShapes(Json& mesh, Buffer& buffer, const ExportShapes& shapes, const TriangleMesh& rest,
               const std::vector<Index>& from)
{
    const auto apart = [&](const std::vector<glm::vec3>& there, const std::vector<glm::vec3>& here) {
        std::vector<glm::vec3> ways;
        ways.reserve(from.size());
        for (const Index v : from)
            ways.push_back(there[v] - here[v]);
        return ways;
    };
    for (const ExportShape& shape : shapes.shapes) {
        std::vector<glm::vec3> moved = apart(shape.positions, rest.positions);
        Json& target = mesh["primitives"][0]["targets"].emplace_back();
        target["POSITION"] = buffer.addPositions(moved);
        if (!shape.normals.empty()) {
            std::vector<glm::vec3> turned = apart(shape.normals, rest.normals);
            target["NORMAL"] = buffer.addFloats(turned, coarseBits, "VEC3");
        }
        mesh["weights"].push_back(0.0);
        mesh["extras"]["targetNames"].push_back(shape.name);
    }
}

} // namespace ramure::glb
