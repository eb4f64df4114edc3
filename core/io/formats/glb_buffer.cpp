#include "core/base/file_writer.h"
#include "core/io/formats/glb_parts.h"

#include <limits>

namespace ramure::glb {

std::size_t Buffer::addView(std::string_view bytes, Target target)
{
    m_bytes.resize((m_bytes.size() + 3) / 4 * 4, '\0');
    Json view{{"buffer", 0}, {"byteOffset", m_bytes.size()}, {"byteLength", bytes.size()}};
    if (target != Target::None)
        view["target"] = static_cast<int>(target);
    m_bytes.append(bytes);
    m_views.push_back(std::move(view));
    return m_views.size() - 1;
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
    m_bytes.resize((m_bytes.size() + 3) / 4 * 4, '\0');
    root["buffers"] = Json::array({{{"byteLength", m_bytes.size()}}});
    root["bufferViews"] = std::move(m_views);
    root["accessors"] = std::move(m_accessors);
    // Names come from files of any kind; what is no UTF-8 in them becomes a question mark.
    std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::uint64_t size = 12 + 8 + text.size() + 8 + m_bytes.size();
    if (size > std::numeric_limits<std::uint32_t>::max()) {
        auto error =
            fail(ErrorCode::Limit, RAMURE_NOOP("a GLB holds up to 4 GiB: fewer leaves or triangles"));
        error.value().file = path;
        return error;
    }
    auto out = FileWriter::open(path);
    if (!out)
        return fail(std::move(out.error()));
    append(*out, 0x46546C67U); // "glTF"
    append(*out, 2);
    append(*out, static_cast<std::uint32_t>(size));
    append(*out, static_cast<std::uint32_t>(text.size()));
    append(*out, 0x4E4F534AU); // "JSON"
    out->append(text);
    append(*out, static_cast<std::uint32_t>(m_bytes.size()));
    append(*out, 0x004E4942U); // "BIN"
    constexpr std::size_t piece = std::size_t(16) << 20;
    for (std::size_t at = 0; at < m_bytes.size() && out->isGood(); at += piece) {
        progress.report(double(at) / double(m_bytes.size()));
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        out->append(std::string_view(m_bytes).substr(at, piece));
    }
    return out->commit();
}

} // namespace ramure::glb
