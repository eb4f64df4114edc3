#include "widgets/view/render/crowd_forms.h"

#include "core/lod/tree_levels.h"
#include "core/math/reproducible.h"
#include "core/surface/mesh/normals.h"
#include <algorithm>
#include <array>
#include <glm/gtc/constants.hpp>

namespace ramure {
namespace {

constexpr int shownBarkSize = 256; ///< pixels a side
/// Triangles of the levels, and the height in pixels down to which each is shown.
constexpr std::array<std::pair<std::int64_t, double>, 3> levels{
    {{20'000, 260.0}, {4'000, 110.0}, {1'000, 44.0}}};

template <class Colour, class Weight>
glm::vec3 meanOf(const std::vector<Colour>& colours, const Weight& weightOf)
{
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const auto [counts, factor] = weightOf(i);
        sum += counts * factor * glm::dvec3(colours[i]);
        weights += counts;
    }
    return weights > 0.0 ? glm::vec3(sum / (255.0 * weights)) : glm::vec3(1.0f);
}

glm::vec3 meanOf(const SurfaceImages& images)
{
    return meanOf(images.colour,
                  [&](std::size_t i) { return std::pair(images.colour[i].a >= 128 ? 1.0 : 0.0, 1.0); });
}

glm::vec3 meanOf(const BarkMaps& bark)
{
    return meanOf(bark.colour,
                  [&](std::size_t i) { return std::pair(1.0, double(bark.occlusion[i]) / 255.0); });
}

/// Cuts cards of two triangles each into pieces: their light is found at the corners.
TriangleMesh parted(const TriangleMesh& cards)
{
    constexpr Index across = 2, up = 2;
    TriangleMesh made;
    for (Index first = 0; first + 3 < cards.vertexCount(); first += 4) {
        const Index from = made.vertexCount();
        for (Index y = 0; y <= up; ++y)
            for (Index x = 0; x <= across; ++x) {
                const float s = float(x) / float(across), t = float(y) / float(up);
                const auto at = [&](const auto& list) {
                    return (1.0f - t) * ((1.0f - s) * list[first] + s * list[first + 1]) +
                           t * ((1.0f - s) * list[first + 3] + s * list[first + 2]);
                };
                made.positions.push_back(at(cards.positions));
                made.uv.push_back(at(cards.uv));
                made.normals.push_back(cards.normals[first]);
            }
        for (Index y = 0; y < up; ++y)
            for (Index x = 0; x < across; ++x) {
                const Index a = from + y * (across + 1) + x, b = a + across + 1;
                made.triangles.emplace_back(a, a + 1, b + 1);
                made.triangles.emplace_back(a, b + 1, b);
            }
    }
    return made;
}

/// Makes the last form of the one before it, a billboard, which is then for more pixels.
CrowdForm plainer(CrowdForm& parted, const TriangleMesh& cards)
{
    constexpr double leastParted = 16.0; // pixels
    constexpr float nearMiddle = 0.55f;  // the corners are outside of the crown
    CrowdForm plain = parted;
    parted.leastPixels = leastParted;
    plain.triangles = std::int64_t(cards.triangles.size());
    plain.parts.front().shape = std::make_shared<const MeshCopies>(shapeOf(cards));
    plain.parts.front().flat = nearMiddle;
    return plain;
}

/// Makes the forms of one tree.
class FormMaker
{
public:
    FormMaker(const TreeResult& tree, const NodeParams& params)
        : m_tree(tree)
        , m_params(params)
    {
        if (params.bark.family == BarkFamily::Plain || !params.barkPictures.isEmpty())
            return;
        m_bark = std::make_shared<const BarkMaps>(barkMaps(params.bark, shownBarkSize).value());
        m_barkMean = meanOf(*m_bark);
    }
    [[nodiscard]] CrowdForm form(const TreeLevel& level, double leastPixels) const
    {
        CrowdForm form;
        form.leastPixels = leastPixels;
        if (level.billboard) {
            Material cards = leaves();
            cards.name = "billboard";
            cards.colour = glm::u8vec3(255);
            cards.leaf = LeafShape::Faithful;
            cards.pictures = {};
            cards.sprays = level.billboardAtlas;
            add(form, parted(*level.billboard), std::move(cards));
            for (CrowdPart& part : form.parts)
                part.flat = 1.0f;
        }
        if (level.bark || level.branches) {
            add(form, level.bark ? *level.bark : level.branches->mesh,
                barkMaterial(m_params.bark, m_params.barkPictures));
            if (!form.parts.empty() && m_bark && !form.parts.back().shape->shape.uv.empty()) {
                form.parts.back().bark = m_bark;
                form.parts.back().mean = m_barkMean;
            }
        }
        if (level.leaves)
            add(form, *level.leaves, level.sprays ? spraysMaterial(leaves(), level.sprays) : leaves());
        if (level.apples)
            add(form, *level.apples, fruit());
        if (level.cuts)
            add(form, *level.cuts, woodMaterial());
        return form;
    }

private:
    [[nodiscard]] Material leaves() const
    {
        return m_tree.foliage ? leavesMaterial(*m_tree.foliage, m_params.leafPictures) : leavesMaterial();
    }
    [[nodiscard]] Material fruit() const
    {
        return m_tree.foliage ? applesMaterial(m_tree.foliage->fruit.kind, m_params.fruitPictures)
                              : applesMaterial();
    }
    static void add(CrowdForm& form, TriangleMesh mesh, Material material)
    {
        if (mesh.empty())
            return;
        if (mesh.normals.size() != mesh.positions.size())
            computeNormals(mesh);
        CrowdPart part;
        part.shape = std::make_shared<const MeshCopies>(shapeOf(mesh));
        part.material = std::move(material);
        const bool isPictured = part.material.sprays || !part.material.pictures.isEmpty();
        if (isPictured && !part.shape->shape.uv.empty()) {
            part.images = std::make_shared<const SurfaceImages>(surfaceImages(part.material));
            part.mean = meanOf(*part.images);
        }
        form.triangles += std::int64_t(mesh.triangles.size());
        form.parts.push_back(std::move(part));
    }

    const TreeResult& m_tree;
    const NodeParams& m_params;
    std::shared_ptr<const BarkMaps> m_bark;
    glm::vec3 m_barkMean{1.0f};
};

} // namespace

Expected<CrowdForms> crowdForms(const TreeResult& tree, const NodeParams& params, const Progress& progress)
{
    LevelOptions options{.count = std::int64_t(levels.size()), .cards = true, .billboard = true};
    for (const auto& [triangles, pixels] : levels)
        options.budgets.push_back(triangles);
    auto made = treeLevels(tree, params, options, {}, progress.part(0.0, 0.6));
    if (!made && made.error().code == ErrorCode::Limit) { // of a tree that has less: the billboard alone
        options.count = 1;
        options.budgets.clear();
        made = treeLevels(tree, params, options, {}, progress.part(0.0, 0.6));
    }
    RAMURE_TRY(made);
    const FormMaker maker(tree, params);
    CrowdForms forms;
    for (std::size_t i = 0; i < made->size(); ++i) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        const std::size_t fromLast = made->size() - i; // 1: the billboard
        CrowdForm form =
            maker.form((*made)[i], fromLast == 1 ? 0.0 : levels[levels.size() + 1 - fromLast].second);
        if (!form.parts.empty())
            forms.push_back(std::move(form));
        progress.report(0.6 + 0.4 * double(i + 1) / double(made->size()));
    }
    if (made->back().billboard && !forms.empty())
        forms.push_back(plainer(forms.back(), *made->back().billboard));
    return forms;
}

CrowdForms standInForms(const Box& box, const TreeResult& tree, const NodeParams& params)
{
    constexpr Index around = 8, rings = 5;
    TriangleMesh egg;
    for (Index ring = 0; ring <= rings; ++ring) {
        const auto [out, up] = maths::sincos(glm::pi<double>() * double(ring) / rings);
        for (Index i = 0; i < around; ++i) {
            const auto [sine, cosine] = maths::sincos(glm::two_pi<double>() * double(i) / around);
            const glm::dvec3 way(out * cosine, up, out * sine);
            egg.positions.emplace_back(box.centre() + 0.5 * box.size() * way);
            egg.normals.emplace_back(way);
        }
    }
    for (Index ring = 0; ring < rings; ++ring)
        for (Index i = 0; i < around; ++i) {
            const Index a = ring * around + i, b = ring * around + (i + 1) % around;
            egg.triangles.emplace_back(a, b, a + around);
            egg.triangles.emplace_back(b, b + around, a + around);
        }
    CrowdPart part;
    part.shape = std::make_shared<const MeshCopies>(shapeOf(egg));
    part.material = tree.foliage ? leavesMaterial(*tree.foliage, params.leafPictures) : leavesMaterial();
    part.material.pictures = {};
    if (part.material.pigments)
        part.material.colour = part.material.mean;
    part.material.twoSided = true;
    return {CrowdForm{{part}, std::int64_t(egg.triangles.size()), 0.0}};
}

CrowdForms plainForms(const std::vector<MeshItem>& items)
{
    CrowdForm form;
    for (const MeshItem& item : items) {
        if (item.copies || item.mesh.empty() || item.isMark)
            continue;
        CrowdPart part;
        part.shape = std::make_shared<const MeshCopies>(shapeOf(*item.mesh));
        part.material = item.material;
        part.images = part.shape->shape.uv.empty() ? nullptr : item.images;
        if (part.images)
            part.mean = meanOf(*part.images);
        form.triangles += item.mesh.faceCount();
        form.parts.push_back(std::move(part));
    }
    return form.parts.empty() ? CrowdForms() : CrowdForms{std::move(form)};
}

} // namespace ramure
