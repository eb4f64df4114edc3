/// \file
/// 3MF: meshes as XML in a ZIP archive, with a unit (3MF core specification 1.3). lib3mf would write it too,
/// but gives every object a number drawn by chance: the same tree would be another file each time.

#include "core/base/version.h"
#include "core/io/formats/file_format.h"
#include "core/io/formats/print/three_mf_reader.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/write_parts.h"
#include "core/io/zip_file.h"
#include "core/surface/mesh/transformed.h"
#include <glm/matrix.hpp>

namespace ramure {
namespace {

constexpr const char* xmlHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// The space stands on a line of its own, unpacked, where fileSpaceIn finds it.
std::string contentTypes(const std::string& comment)
{
    std::string out = xmlHead;
    if (!comment.empty())
        out += "<!--\n# " + writing::oneLine(comment) + "\n-->\n";
    return out + "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
                 "<Default Extension=\"rels\" "
                 "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
                 "<Default Extension=\"model\" "
                 "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
}

std::string relations()
{
    return std::string(xmlHead) +
           "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
           "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
           "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
}

/// A name fit for an attribute.
std::string escaped(const std::string& name)
{
    std::string out;
    for (const char c : writing::oneLine(name))
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    return out;
}

/// Numbers as text behind each other, in memory: the archive is packed from there.
class ModelText
{
public:
    ModelText(const Progress& progress, std::size_t elements)
        : m_progress(progress)
        , m_elements(elements)
    {
    }
    std::string text{};

    template <class Append> bool each(std::size_t count, std::size_t room, Append&& append)
    {
        for (std::size_t begin = 0; begin < count; begin += writing::chunk) {
            const std::size_t end = std::min(count, begin + writing::chunk);
            const std::size_t before = text.size();
            text.resize(before + (end - begin) * room);
            char* to = text.data() + before;
            for (std::size_t i = begin; i < end; ++i)
                to = append(to, i);
            text.resize(static_cast<std::size_t>(to - text.data()));
            m_done += end - begin;
            m_progress.report(double(m_done) / double(m_elements));
            if (m_progress.cancelled())
                return false;
        }
        return true;
    }

private:
    const Progress& m_progress;
    std::size_t m_elements, m_done = 0;
};

bool appendMesh(ModelText& out, const TriangleMesh& mesh)
{
    using writing::appendText;
    constexpr std::size_t longest = 48 + 3 * maxFloatText;
    out.text += "<mesh><vertices>\n";
    if (!out.each(mesh.positions.size(), longest, [&mesh](char* to, std::size_t i) {
            const glm::vec3& p = mesh.positions[i];
            to = appendFloat(appendText(to, "<vertex x=\""), p.x);
            to = appendFloat(appendText(to, "\" y=\""), p.y);
            to = appendFloat(appendText(to, "\" z=\""), p.z);
            return appendText(to, "\"/>\n");
        }))
        return false;
    out.text += "</vertices><triangles>\n";
    if (!out.each(mesh.triangles.size(), longest, [&mesh](char* to, std::size_t i) {
            const glm::uvec3& t = mesh.triangles[i];
            to = appendIndex(appendText(to, "<triangle v1=\""), t.x);
            to = appendIndex(appendText(to, "\" v2=\""), t.y);
            to = appendIndex(appendText(to, "\" v3=\""), t.z);
            return appendText(to, "\"/>\n");
        }))
        return false;
    out.text += "</triangles></mesh>";
    return true;
}

/// Triangles with a corner twice are not allowed; they have no area.
TriangleMesh withoutFolded(const TriangleMesh& mesh)
{
    TriangleMesh out;
    out.positions = mesh.positions;
    for (const glm::uvec3& t : mesh.triangles)
        if (t.x != t.y && t.y != t.z && t.z != t.x)
            out.triangles.push_back(t);
    return out;
}

Expected<void> exportThreeMf(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                             const Progress& progress)
{
    const FlatScene flat = flattened(scene);
    const std::vector<MeshPart> parts = flat.parts();
    if (const auto finite = writing::checkFinite(parts, path); !finite)
        return finite;
    std::size_t elements = 1;
    for (const MeshPart& part : parts)
        elements += part.mesh->positions.size() + part.mesh->triangles.size();
    constexpr const char* units[] = {"meter", "centimeter", "millimeter", "", "inch", "foot"};
    const char* unit = units[scene.space.unit]; // of lengthUnits[]
    if (*unit == '\0') {
        auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("a 3MF knows no kilometres: another unit, please"));
        error.value().file = path;
        return error;
    }
    const Progress writing = progress.part(0.0, 0.3);
    ModelText out(writing, elements);
    out.text = std::string(xmlHead) + "<model unit=\"" + unit +
               "\" xml:lang=\"en-US\" "
               "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
               "<metadata name=\"Application\">Ramure " RAMURE_VERSION "</metadata>\n<resources>\n";
    std::string items;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string id = std::to_string(i + 1);
        out.text += "<object id=\"" + id + "\" type=\"model\" name=\"" + escaped(parts[i].name) + "\">";
        if (!appendMesh(out, withoutFolded(*parts[i].mesh))) {
            auto error = fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            error.value().file = path;
            return error;
        }
        out.text += "</object>\n";
        items += "<item objectid=\"" + id + "\"/>";
    }
    out.text += "</resources>\n<build>" + items + "</build>\n</model>\n";
    const std::string types = contentTypes(options.comment), related = relations();
    const ZipEntry entries[] = {{"[Content_Types].xml", types, false},
                                {"_rels/.rels", related, false},
                                {"3D/3dmodel.model", out.text, true}};
    return writeZip(path, entries, progress.part(0.3, 1.0));
}

FileRates threeMfRates(bool /*texture*/, double digits)
{
    // Packed: numbers of both kinds shrink to about a quarter of their text.
    return {12.0, 5.0 + digits};
}

} // namespace

extern const FileFormat threeMfFormat;
const FileFormat threeMfFormat = {
    .id = "3mf",
    .ending = "3mf",
    .name = RAMURE_NOOP("3MF"),
    .choice = RAMURE_NOOP("3MF, for printers"),
    .help = "packed, with its unit, for printers: see --print",
    .holds = holdsSpace,
    .read = &readThreeMf,
    .import = &importBlender,
    .write = &exportThreeMf,
    .rates = &threeMfRates,
};

} // namespace ramure
