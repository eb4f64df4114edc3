#include "core/base/file_writer.h"
#include "core/io/formats/glb/glb_packed.h"

#include <glm/common.hpp>
#include <limits>

namespace ramure::glb {

static constexpr const char *compression = "EXT_meshopt_compression", *quantisation = "KHR_mesh_quantization";

std::size_t Buffer::addView(std::string_view bytes, Target target)
{
    Json view{{"buffer", 0}, {"byteOffset", m_size}, {"byteLength", bytes.size()}};
    if (target != Target::None)
        view["target"] = static_cast<int>(target);
    const std::size_t whole = (bytes.size() + 3) / 4 * 4; // the next begins where any number may
    m_size += whole;
    if (m_size <= std::numeric_limits<std::uint32_t>::max()) {
        std::string& piece = m_pieces.emplace_back();
        piece.reserve(whole);
        piece.append(bytes).resize(whole, '\0');
    } else {
        m_pieces.clear();
    }
    m_views.push_back(std::move(view));
    return m_views.size() - 1;
}

/// In a second buffer, which is nowhere in the file, stands what it becomes.
std::size_t Buffer::addPacked(const Packed& values, Target target)
{
    const std::size_t view = addView(values.bytes, target);
    Json& json = m_views[view];
    const std::size_t size = values.count * values.stride;
    json["extensions"][compression] = {{"buffer", 0},
                                       {"byteOffset", json["byteOffset"]},
                                       {"byteLength", json["byteLength"]},
                                       {"byteStride", values.stride},
                                       {"count", values.count},
                                       {"mode", values.mode}};
    if (std::string_view(values.filter) != "NONE")
        json["extensions"][compression]["filter"] = values.filter;
    json["buffer"] = 1;
    json["byteOffset"] = m_unpacked;
    json["byteLength"] = size;
    m_unpacked += (size + 3) / 4 * 4;
    return view;
}

std::size_t Buffer::addNumbers(std::string_view bytes, std::size_t stride, Target target)
{
    return m_isPacked && stride % 4 == 0 && !bytes.empty() ? addPacked(packed(bytes, stride), target)
                                                           : addView(bytes, target);
}

std::size_t Buffer::addRounded(std::span<float> values, std::size_t components, int bits, Target target)
{
    if (m_isPacked)
        return addPacked(packedFloats(values, components, bits), target);
    return addView({reinterpret_cast<const char*>(values.data()), values.size_bytes()}, target);
}

std::size_t Buffer::addPositions(std::vector<glm::vec3>& positions)
{
    const std::size_t number = addFloats(positions, fineBits, "VEC3");
    glm::vec3 low = positions.front(), high = positions.front();
    for (const glm::vec3& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    accessor(number)["min"] = {low.x, low.y, low.z};
    accessor(number)["max"] = {high.x, high.y, high.z};
    return number;
}

std::size_t Buffer::addDirections(const std::vector<glm::vec3>& directions, bool isFine)
{
    if (!m_isPacked)
        return addAccessor(addValues(directions, Target::Vertices), Number::Float, "VEC3", directions.size());
    m_isRounded = true;
    std::vector<glm::vec4> padded;
    padded.reserve(directions.size());
    for (const glm::vec3& direction : directions)
        padded.emplace_back(direction, 1.0F);
    const std::size_t view = addPacked(packedDirections(padded, isFine), Target::Vertices);
    m_views[view]["byteStride"] = isFine ? 8 : 4;
    return addAccessor(view, isFine ? Number::Signed16 : Number::Signed8, "VEC3", directions.size(), true);
}

std::size_t Buffer::addTangents(const std::vector<glm::vec4>& tangents)
{
    if (!m_isPacked)
        return addAccessor(addValues(tangents, Target::Vertices), Number::Float, "VEC4", tangents.size());
    m_isRounded = true;
    return addAccessor(addPacked(packedDirections(tangents), Target::Vertices), Number::Signed8, "VEC4",
                       tangents.size(), true);
}

std::size_t Buffer::addTurns(const std::vector<glm::vec4>& quaternions)
{
    if (!m_isPacked)
        return addAccessor(addValues(quaternions), Number::Float, "VEC4", quaternions.size());
    return addAccessor(addPacked(packedTurns(quaternions), Target::None), Number::Signed16, "VEC4",
                       quaternions.size(), true);
}

void Buffer::tellExtensions(Json& root) const
{
    if (m_unpacked == 0)
        return;
    root["buffers"].push_back(
        {{"byteLength", m_unpacked}, {"extensions", {{compression, {{"fallback", true}}}}}});
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        root[list].push_back(compression);
        if (m_isRounded)
            root[list].push_back(quantisation);
    }
}

std::size_t Buffer::addAccessor(std::size_t view, Number number, const char* type, std::size_t count,
                                bool isNormalised)
{
    Json accessor{
        {"bufferView", view}, {"componentType", static_cast<int>(number)}, {"type", type}, {"count", count}};
    if (isNormalised)
        accessor["normalized"] = true;
    m_accessors.push_back(std::move(accessor));
    return m_accessors.size() - 1;
}

/// Little-endian, as the machines are that the program runs on.
static void append(FileWriter& out, std::uint32_t number)
{
    out.append({reinterpret_cast<const char*>(&number), sizeof number});
}

Expected<void> Buffer::write(const std::string& path, Json root, const Progress& progress) &&
{
    root["buffers"] = Json::array({{{"byteLength", m_size}}});
    tellExtensions(root);
    root["bufferViews"] = std::move(m_views);
    root["accessors"] = std::move(m_accessors);
    // Names come from files of any kind; what is no UTF-8 in them becomes a question mark.
    std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::uint64_t size = 12 + 8 + text.size() + 8 + m_size;
    if (size > std::numeric_limits<std::uint32_t>::max()) {
        auto error =
            fail(ErrorCode::Limit, RAMURE_NOOP("a GLB holds up to 4 GiB: fewer leaves or triangles"));
        error.value().file = path;
        return error;
    }
    auto out = FileWriter::open(path);
    RAMURE_TRY(out);
    append(*out, 0x46546C67U); // "glTF"
    append(*out, 2);
    append(*out, static_cast<std::uint32_t>(size));
    append(*out, static_cast<std::uint32_t>(text.size()));
    append(*out, 0x4E4F534AU); // "JSON"
    out->append(text);
    append(*out, static_cast<std::uint32_t>(m_size));
    append(*out, 0x004E4942U); // "BIN"
    constexpr std::size_t part = std::size_t(16) << 20;
    std::size_t done = 0;
    for (std::string& piece : m_pieces) {
        for (std::size_t at = 0; at < piece.size() && out->isGood(); at += part) {
            progress.report(double(done + at) / double(m_size));
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            out->append(std::string_view(piece).substr(at, part));
        }
        done += piece.size();
        std::string().swap(piece); // a large scene needs the room
    }
    return out->commit();
}

} // namespace ramure::glb
