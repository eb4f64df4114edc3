#include "core/io/formats/glb/glb_packed.h"

#include <meshoptimizer.h>

namespace ramure::glb {

namespace {

/// The versions that the extension names.
void useVersions()
{
    [[maybe_unused]] static const bool once = [] {
        meshopt_encodeVertexVersion(0);
        meshopt_encodeIndexVersion(1);
        return true;
    }();
}

/// \param values of four bytes \param filter name and function of the extension
template <class Filter>
Packed filtered(std::span<const glm::vec4> values, std::size_t stride, const char* name, Filter encode)
{
    std::string numbers(values.size() * stride, '\0');
    encode(numbers.data(), values.size(), stride, &values[0].x);
    Packed out = packed(numbers, stride);
    out.filter = name;
    return out;
}

template <class T> void reorder(std::vector<T>& values, const std::vector<Index>& places)
{
    if (values.empty())
        return;
    std::vector<T> moved(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        moved[places[i]] = values[i];
    values = std::move(moved);
}

} // namespace

Packed packed(std::string_view values, std::size_t stride)
{
    useVersions();
    Packed out;
    out.stride = stride;
    out.count = values.size() / stride;
    out.bytes.resize(meshopt_encodeVertexBufferBound(out.count, stride));
    out.bytes.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.bytes.data()),
                                                out.bytes.size(), values.data(), out.count, stride));
    return out;
}

Packed packedFloats(std::span<float> values, std::size_t components, int bits)
{
    const std::size_t stride = components * sizeof(float), count = values.size() / components;
    std::string numbers(values.size_bytes(), '\0');
    meshopt_encodeFilterExp(numbers.data(), count, stride, bits, values.data());
    Packed out = packed(numbers, stride);
    out.filter = "EXPONENTIAL";
    meshopt_decodeFilterExp(numbers.data(), count, stride);
    numbers.copy(reinterpret_cast<char*>(values.data()), numbers.size());
    return out;
}

Packed packedDirections(std::span<const glm::vec4> directions, bool isFine)
{
    const int bits = isFine ? 14 : 8;
    return filtered(directions, isFine ? 8 : 4, "OCTAHEDRAL",
                    [bits](void* to, std::size_t count, std::size_t stride, const float* from) {
                        meshopt_encodeFilterOct(to, count, stride, bits, from);
                    });
}

Packed packedTurns(std::span<const glm::vec4> quaternions)
{
    return filtered(quaternions, 8, "QUATERNION",
                    [](void* to, std::size_t count, std::size_t stride, const float* from) {
                        meshopt_encodeFilterQuat(to, count, stride, 12, from);
                    });
}

Packed packedTriangles(Vertices& vertices)
{
    useVersions();
    std::vector<Index>& indices = vertices.indices;
    const std::size_t count = vertices.positions.size();
    std::vector<Index> mergedTo(count, noIndex), places(count);
    for (std::size_t i = 0; i < vertices.mergeIndices.size(); ++i)
        mergedTo[indices[vertices.mergeIndices[i]]] = vertices.mergeValues[i];
    meshopt_optimizeVertexCache(indices.data(), indices.data(), indices.size(), count);
    meshopt_optimizeVertexFetchRemap(places.data(), indices.data(), indices.size(), count);
    for (Index& index : indices)
        index = places[index];
    for (Index& to : mergedTo)
        to = to == noIndex ? noIndex : places[to];
    reorder(mergedTo, places);
    reorder(vertices.positions, places);
    reorder(vertices.normals, places);
    reorder(vertices.uv, places);
    reorder(vertices.tangents, places);
    reorder(vertices.colours, places);
    reorder(vertices.from, places);
    Packed out;
    out.mode = "TRIANGLES";
    out.stride = sizeof(Index);
    out.count = indices.size();
    out.bytes.resize(meshopt_encodeIndexBufferBound(indices.size(), count));
    out.bytes.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(out.bytes.data()),
                                               out.bytes.size(), indices.data(), indices.size()));
    meshopt_decodeIndexBuffer(indices.data(), indices.size(), sizeof(Index),
                              reinterpret_cast<const unsigned char*>(out.bytes.data()), out.bytes.size());
    vertices.mergeIndices.clear();
    vertices.mergeValues.clear();
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (const Index to = mergedTo[indices[i]]; to != noIndex) {
            vertices.mergeIndices.push_back(static_cast<Index>(i));
            vertices.mergeValues.push_back(to);
        }
    return out;
}

} // namespace ramure::glb
