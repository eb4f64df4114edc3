#include "core/io/formats/glb/glb_file.h"

#include "core/base/plain_text.h"
#include "core/io/formats/glb/glb_unpack.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace ramure::glb {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie in the file");

constexpr std::size_t mostJson = std::size_t(256) << 20, mostUnpacked = std::size_t(2) << 30;
/// Numbers of an accessor that has no bytes in the file.
constexpr std::size_t mostZeros = std::size_t(1) << 24;

/// Those that change what vertices and nodes are; materials without theirs are plainer.
constexpr std::array known{
    "KHR_mesh_quantization",
    "EXT_meshopt_compression",
    "EXT_mesh_manifold",
    "EXT_mesh_gpu_instancing",
    "MSFT_lod",
};

std::uint32_t word(std::string_view bytes, std::size_t at)
{
    std::uint32_t out = 0;
    std::memcpy(&out, bytes.data() + at, sizeof out);
    return out;
}

/// Without what it says, the mesh is there all the same: a picture that cannot be read is a note.
bool isLook(std::string_view extension)
{
    constexpr std::array prefixes{"KHR_materials_", "EXT_materials_", "KHR_texture_", "EXT_texture_",
                                  "MSFT_texture_",  "MSFT_packing_",  "KHR_lights_",  "EXT_lights_"};
    return std::ranges::any_of(prefixes, [&](const char* begin) { return extension.starts_with(begin); });
}

std::size_t sizeOf(std::size_t type)
{
    switch (type) {
    case 5120:
    case 5121:
        return 1;
    case 5122:
    case 5123:
        return 2;
    case 5125:
    case 5126:
        return 4;
    default:
        return 0;
    }
}

template <class From> double numberAt(const char* bytes)
{
    From out;
    std::memcpy(&out, bytes, sizeof out);
    return double(out);
}

double numberAt(const char* bytes, std::size_t type)
{
    switch (type) {
    case 5120:
        return numberAt<std::int8_t>(bytes);
    case 5121:
        return numberAt<std::uint8_t>(bytes);
    case 5122:
        return numberAt<std::int16_t>(bytes);
    case 5123:
        return numberAt<std::uint16_t>(bytes);
    case 5125:
        return numberAt<std::uint32_t>(bytes);
    default:
        return double(numberAt<float>(bytes));
    }
}

/// What a whole number counts as where the accessor is normalised.
double unitOf(std::size_t type)
{
    switch (type) {
    case 5120:
        return 127.0;
    case 5121:
        return 255.0;
    case 5122:
        return 32767.0;
    case 5123:
        return 65535.0;
    default:
        return 1.0;
    }
}

std::size_t componentsOf(std::string_view type)
{
    constexpr std::pair<std::string_view, std::size_t> types[] = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    for (const auto& [name, count] : types)
        if (name == type)
            return count;
    return 0;
}

} // namespace

std::string placeOf(const char* list, std::size_t number)
{
    return std::string(list) + "[" + std::to_string(number) + "]";
}

tl::unexpected<Error> wrong(const std::string& place, const char* text, std::vector<std::string> args,
                            ErrorCode code)
{
    auto error = fail(code, text, std::move(args));
    error.value().path = place;
    return error;
}

const Json* member(const Json& object, const char* name)
{
    if (!object.is_object())
        return nullptr;
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
}

std::string textOf(const Json& object, const char* name)
{
    const Json* found = member(object, name);
    return found && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<std::size_t> numberOf(const Json& object, const char* name)
{
    const Json* found = member(object, name);
    if (!found || !found->is_number())
        return std::nullopt;
    const double number = found->get<double>(); // some write 3.0
    if (!(number >= 0.0 && number <= 9e15 && number == std::floor(number)))
        return std::nullopt;
    return static_cast<std::size_t>(number);
}

Expected<void> numbersOf(const Json& object, const char* name, std::span<double> out,
                         const std::string& place)
{
    const Json* found = member(object, name);
    if (!found)
        return {};
    const std::string inside = place + "." + name;
    if (!found->is_array() || found->size() != out.size())
        return wrong(inside, RAMURE_NOOP("%1 numbers expected"), {std::to_string(out.size())});
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Json& number = (*found)[i];
        if (!number.is_number() || !std::isfinite(number.get<double>()))
            return wrong(inside, RAMURE_NOOP("%1 numbers expected"), {std::to_string(out.size())});
        out[i] = number.get<double>();
    }
    return {};
}

Expected<File> File::open(const std::string& path, const Progress& progress)
{
    const auto named = [&path](Error error) {
        error.file = path;
        return fail(std::move(error));
    };
    auto input = reading::InputFile::open(path);
    RAMURE_TRY(input);
    // What is too large or none at all is not read to its end.
    std::array<char, 20> head{};
    if (input->isRegular()) {
        const auto got = input->read(head.data(), head.size());
        RAMURE_TRY(got);
        const std::string_view bytes(head.data(), *got);
        if (bytes.size() == head.size() && bytes.starts_with("glTF") && word(bytes, 12) > mostJson)
            return named(wrong({}, RAMURE_NOOP("the JSON of the file has more than %1 MiB"),
                               {std::to_string(mostJson >> 20U)}, ErrorCode::Limit)
                             .value());
        input->rewind();
    }
    auto bytes = reading::loadFile(*input);
    RAMURE_TRY(bytes);
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    File out;
    out.m_bytes = std::move(*bytes);
    if (auto read = out.split(); !read)
        return named(std::move(read.error()));
    return out;
}

/// Into the JSON and the binary part.
Expected<void> File::split()
{
    constexpr std::size_t head = 12, chunkHead = 8;
    std::string_view bytes = m_bytes;
    if (bytes.size() < head + chunkHead || !bytes.starts_with("glTF"))
        return fail(ErrorCode::Syntax, RAMURE_NOOP("this is no GLB file"));
    if (word(bytes, 4) != 2)
        return fail(ErrorCode::Version, RAMURE_NOOP("a GLB of version %1: 2 can be read"),
                    {std::to_string(word(bytes, 4))});
    if (const std::size_t said = word(bytes, 8); said > bytes.size())
        return fail(ErrorCode::Syntax, RAMURE_NOOP("the file is cut off: %1 of %2 bytes are there"),
                    {std::to_string(bytes.size()), std::to_string(said)});
    else if (said < bytes.size() && said >= head + chunkHead) {
        m_notes.push_back(std::to_string(bytes.size() - said) + " bytes behind the end of the file");
        bytes = bytes.substr(0, said);
    }
    std::string_view json;
    bool hasJson = false, hasBinary = false;
    for (std::size_t at = head; at + chunkHead <= bytes.size();) {
        const std::size_t size = word(bytes, at), type = word(bytes, at + 4);
        at += chunkHead;
        if (size > bytes.size() - at)
            return fail(ErrorCode::Syntax, RAMURE_NOOP("a part of the file goes beyond its end"));
        if (type == 0x4E4F534AU && !hasJson) {
            json = bytes.substr(at, size);
            hasJson = true;
        } else if (type == 0x004E4942U && !hasBinary) {
            m_chunk = bytes.substr(at, size);
            hasBinary = true;
        }
        at += size;
    }
    if (!hasJson || json.size() > mostJson)
        return fail(ErrorCode::Syntax, RAMURE_NOOP("the file has no JSON part"));
    return parse(json);
}

Expected<void> File::parse(std::string_view text)
{
    const PlainText plain(text); // some programs fill up with zeros, not with blanks
    m_root = Json::parse(plain.view(), nullptr, false);
    if (m_root.is_discarded() || !m_root.is_object())
        return fail(ErrorCode::Syntax, RAMURE_NOOP("the JSON of the file is broken"));
    return checkExtensions();
}

Expected<void> File::checkExtensions() const
{
    for (const Json& name : list("extensionsRequired")) {
        const std::string text = name.is_string() ? name.get<std::string>() : std::string();
        if (std::ranges::find(known, text) == known.end() && !isLook(text))
            return wrong("extensionsRequired", RAMURE_NOOP("the file needs %1, which cannot be read"),
                         {reading::excerpt(text)}, ErrorCode::Unknown);
    }
    return {};
}

std::size_t File::components(std::optional<std::size_t> accessor) const
{
    const auto json = element("accessors", accessor, {});
    return json ? componentsOf(textOf(**json, "type")) : 0;
}

const Json& File::list(const char* name) const
{
    static const Json none = Json::array();
    const Json* found = member(m_root, name);
    return found && found->is_array() ? *found : none;
}

Expected<const Json*> File::element(const char* listName, std::optional<std::size_t> number,
                                    const std::string& place) const
{
    const Json& all = list(listName);
    if (!number || *number >= all.size() || !all[*number].is_object())
        return wrong(place, RAMURE_NOOP("there is no %1"),
                     {number ? placeOf(listName, *number) : std::string(listName)});
    return &all[*number];
}

/// A buffer that stands elsewhere is not looked for: a GLB is one file.
Expected<std::string_view> File::buffer(std::optional<std::size_t> number, const std::string& place)
{
    const auto json = element("buffers", number, place);
    RAMURE_TRY(json);
    const std::string inside = placeOf("buffers", *number);
    const std::size_t size = numberOf(**json, "byteLength").value_or(0);
    if (!member(**json, "uri")) {
        if (*number != 0 || size > m_chunk.size())
            return wrong(inside, RAMURE_NOOP("%1 bytes expected, %2 are there"),
                         {std::to_string(size), std::to_string(*number == 0 ? m_chunk.size() : 0)});
        return m_chunk.substr(0, size);
    }
    if (const auto found = m_buffers.find(*number); found != m_buffers.end())
        return found->second;
    auto decoded = bytesOfUri(textOf(**json, "uri"));
    if (!decoded)
        return wrong(inside, RAMURE_NOOP("a buffer in another file, or broken: export it as one GLB"));
    if (decoded->size() < size)
        return wrong(inside, RAMURE_NOOP("%1 bytes expected, %2 are there"),
                     {std::to_string(size), std::to_string(decoded->size())});
    return m_buffers.emplace(*number, std::move(*decoded)).first->second;
}

Expected<std::string_view> File::view(std::optional<std::size_t> number, const std::string& place)
{
    const auto json = element("bufferViews", number, place);
    RAMURE_TRY(json);
    const Json* extensions = member(**json, "extensions");
    const Json* packed = extensions ? member(*extensions, "EXT_meshopt_compression") : nullptr;
    if (packed)
        return unpacked(*number, *packed);
    const std::string inside = placeOf("bufferViews", *number);
    const auto whole = buffer(numberOf(**json, "buffer"), inside);
    if (!whole)
        return whole;
    const std::size_t offset = numberOf(**json, "byteOffset").value_or(0);
    const auto size = numberOf(**json, "byteLength");
    if (!size || offset > whole->size() || *size > whole->size() - offset)
        return wrong(inside, RAMURE_NOOP("it goes beyond its buffer"));
    return whole->substr(offset, *size);
}

Expected<std::string_view> File::unpacked(std::size_t number, const Json& extension)
{
    if (const auto found = m_views.find(number); found != m_views.end())
        return found->second;
    const std::string inside = placeOf("bufferViews", number);
    const auto whole = buffer(numberOf(extension, "buffer"), inside);
    if (!whole)
        return whole;
    const std::size_t offset = numberOf(extension, "byteOffset").value_or(0),
                      size = numberOf(extension, "byteLength").value_or(0),
                      count = numberOf(extension, "count").value_or(0),
                      stride = numberOf(extension, "byteStride").value_or(0);
    if (offset > whole->size() || size > whole->size() - offset)
        return wrong(inside, RAMURE_NOOP("it goes beyond its buffer"));
    if (stride > 256 || count > (mostUnpacked - m_unpacked) / std::max<std::size_t>(stride, 1))
        return wrong(inside, RAMURE_NOOP("it would unpack to more than a mesh can be"), {}, ErrorCode::Limit);
    auto values = unpack(
        {whole->substr(offset, size), count, stride, textOf(extension, "mode"), textOf(extension, "filter")});
    if (!values)
        return wrong(inside, RAMURE_NOOP("the compressed bytes are broken"));
    m_unpacked += values->size();
    return m_views.emplace(number, std::move(*values)).first->second;
}

struct File::Accessor
{
    const Json* json = nullptr;
    std::string place;
    std::size_t type = 0, count = 0, stride = 0;
    bool isNormalised = false;
    std::string_view bytes; ///< from its first element on; empty: all zeros
};

Expected<File::Accessor> File::accessor(std::optional<std::size_t> number, std::size_t components,
                                        const std::string& place)
{
    const auto json = element("accessors", number, place);
    RAMURE_TRY(json);
    Accessor out;
    out.json = *json;
    out.place = placeOf("accessors", *number);
    out.type = numberOf(**json, "componentType").value_or(0);
    out.count = numberOf(**json, "count").value_or(0);
    const std::size_t size = sizeOf(out.type) * components;
    if (componentsOf(textOf(**json, "type")) != components || size == 0)
        return wrong(out.place, RAMURE_NOOP("%1 numbers an element expected"), {std::to_string(components)});
    if (const Json* normalised = member(**json, "normalized"))
        out.isNormalised = normalised->is_boolean() && normalised->get<bool>();
    out.stride = size;
    if (!member(**json, "bufferView")) {
        if (out.count > mostZeros / components)
            return wrong(out.place, RAMURE_NOOP("%1 elements without bytes are more than a mesh needs"),
                         {std::to_string(out.count)}, ErrorCode::Limit);
        return out;
    }
    const auto viewNumber = numberOf(**json, "bufferView");
    const auto bytes = view(viewNumber, out.place);
    RAMURE_TRY(bytes);
    out.stride = numberOf(list("bufferViews")[*viewNumber], "byteStride").value_or(size);
    const std::size_t offset = numberOf(**json, "byteOffset").value_or(0);
    if (out.stride < size || offset > bytes->size() ||
        (out.count > 0 &&
         (size > bytes->size() - offset || (bytes->size() - offset - size) / out.stride < out.count - 1)))
        return wrong(out.place, RAMURE_NOOP("it goes beyond its view"));
    out.bytes = bytes->substr(offset);
    return out;
}

/// Some elements have other values than their view says.
template <class T>
Expected<void> File::addSparse(std::vector<T>& to, const Accessor& accessor, std::size_t components,
                               const std::string& place)
{
    const Json* sparse = member(*accessor.json, "sparse");
    if (!sparse)
        return {};
    const Json* where = member(*sparse, "indices");
    const Json* what = member(*sparse, "values");
    const std::size_t count = numberOf(*sparse, "count").value_or(0);
    if (!where || !what)
        return wrong(place, RAMURE_NOOP("the sparse values are broken"));
    const auto places = view(numberOf(*where, "bufferView"), place);
    const auto values = view(numberOf(*what, "bufferView"), place);
    if (!places || !values)
        return fail(places ? values.error() : places.error());
    const std::size_t placeType = numberOf(*where, "componentType").value_or(0),
                      placeSize = sizeOf(placeType), size = sizeOf(accessor.type),
                      placeAt = numberOf(*where, "byteOffset").value_or(0),
                      valueAt = numberOf(*what, "byteOffset").value_or(0);
    if (placeSize == 0 || placeType == 5126 || placeAt > places->size() || valueAt > values->size() ||
        (places->size() - placeAt) / placeSize < count ||
        (values->size() - valueAt) / (size * components) < count)
        return wrong(place, RAMURE_NOOP("the sparse values are broken"));
    const double unit = accessor.isNormalised ? unitOf(accessor.type) : 1.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double element = numberAt(places->data() + placeAt + i * placeSize, placeType);
        if (!(element >= 0.0 && element < double(accessor.count)))
            return wrong(place, RAMURE_NOOP("the sparse values are broken"));
        for (std::size_t c = 0; c < components; ++c)
            to[static_cast<std::size_t>(element) * components + c] = static_cast<T>(
                numberAt(values->data() + valueAt + (i * components + c) * size, accessor.type) / unit);
    }
    return {};
}

template <class T>
Expected<std::vector<T>> File::values(std::optional<std::size_t> number, std::size_t components,
                                      const std::string& place)
{
    const auto from = accessor(number, components, place);
    RAMURE_TRY(from);
    constexpr bool isWhole = std::is_integral_v<T>;
    if (isWhole && (from->type == 5126 || from->type == 5120 || from->type == 5122))
        return wrong(from->place, RAMURE_NOOP("whole numbers from 0 on expected"));
    std::vector<T> out(from->count * components, T(0));
    const double unit = from->isNormalised && !isWhole ? unitOf(from->type) : 1.0;
    const std::size_t size = sizeOf(from->type);
    for (std::size_t i = 0; i < from->count && !from->bytes.empty(); ++i)
        for (std::size_t c = 0; c < components; ++c)
            out[i * components + c] = static_cast<T>(
                std::max(numberAt(from->bytes.data() + i * from->stride + c * size, from->type) / unit,
                         from->isNormalised ? -1.0 : std::numeric_limits<double>::lowest()));
    RAMURE_TRY(addSparse(out, *from, components, from->place));
    return out;
}

Expected<std::vector<float>> File::anyFloats(std::optional<std::size_t> accessor, std::size_t components,
                                             const std::string& place)
{
    return values<float>(accessor, components, place);
}

Expected<std::vector<float>> File::floats(std::optional<std::size_t> accessor, std::size_t components,
                                          const std::string& place)
{
    auto out = anyFloats(accessor, components, place);
    if (out && !std::ranges::all_of(*out, [](float number) { return std::isfinite(number); }))
        return wrong(placeOf("accessors", *accessor), RAMURE_NOOP("a number is not finite"));
    return out;
}

Expected<std::vector<Index>> File::indices(std::optional<std::size_t> accessor, std::size_t components,
                                           const std::string& place)
{
    return values<Index>(accessor, components, place);
}

} // namespace ramure::glb
