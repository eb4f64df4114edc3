#include "widgets/view/render/meadow.h"

#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/foliage/place_foliage.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace ramure {
namespace {

constexpr std::size_t mostTufts = 16'000, mostFeet = 24, mostLeaves = 5'000;
constexpr double leastReach = 1e-3, tuftsOfArea = 70.0;    ///< m; a square metre, where they are densest
constexpr double ofReach = 4.5, more = 6.0, widest = 18.0; ///< how far grass goes: of the roots' reach, and m
constexpr double bladeHeight = 0.105, bladeWidth = 0.008;  ///< m

double smoothStep(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A tuft: blades that lean outwards, darker below. Of \p pieces triangles each, or one; wider where they
/// are few, so that as much of the ground is covered.
void addTuft(MeshCopies& made, int blades, int pieces, double wider, LeafDetail coarsest)
{
    TriangleMesh& shape = made.shape;
    const Index from = shape.faceCount();
    for (int blade = 0; blade < blades; ++blade) {
        Random random(7, RandomStream::Terrain, std::uint64_t(blade));
        const double around = 2.399963 * blade, size = random.range(0.55, 1.0);
        const auto [sine, cosine] = maths::sincos(around);
        const glm::dvec3 out(cosine, 0.0, sine), across(-sine, 0.0, cosine);
        const double lean = random.range(0.25, 0.9), half = 0.5 * wider * bladeWidth;
        const glm::dvec3 foot = random.range(0.0, 0.05) * out;
        const auto at = [&](double share) {
            return foot + size * bladeHeight *
                              (share * (1.0 - 0.25 * lean * share) * glm::dvec3(0.0, 1.0, 0.0) +
                               lean * share * share * out);
        };
        const auto add = [&](double share, double side) {
            shape.positions.emplace_back(at(share) + side * half * across);
            // Light on grass is the light on the ground below it, and a little its own.
            shape.normals.push_back(glm::normalize(glm::vec3(0.0f, 1.0f, 0.0f) + 0.22f * glm::vec3(out)));
            const double dark = pieces == 1 ? 0.15 : 0.5; // from afar no foot is seen
            const double bright = 1.0 - dark * (1.0 - std::min(1.0, 1.25 * share));
            made.colours.emplace_back(glm::u8vec3(glm::dvec3(0.94, 1.0, 0.86) * bright * 255.0), 255);
            return shape.vertexCount() - 1;
        };
        const Index a = add(0.0, 1.0), b = add(0.0, -1.0);
        if (pieces == 1) {
            shape.triangles.emplace_back(a, b, add(1.0, 0.0));
            continue;
        }
        const Index c = add(0.55, 0.8), d = add(0.55, -0.8), tip = add(1.0, 0.0);
        shape.triangles.emplace_back(a, b, c);
        shape.triangles.emplace_back(c, b, d);
        shape.triangles.emplace_back(c, d, tip);
    }
    // Seen from behind a blade has the same light: it has two faces, of which one is left out.
    for (Index f = from, end = shape.faceCount(); f < end; ++f) {
        const glm::uvec3 face = shape.triangles[f];
        shape.triangles.emplace_back(face.x, face.z, face.y);
    }
    for (std::size_t how = 0; how <= std::size_t(coarsest); ++how)
        made.detail[how] = {from, shape.faceCount() - from};
}

/// Which a colour is multiplied by: grass is yellower where the ground is dry, patch by patch.
glm::u8vec4 tintOfGrass(const glm::dvec2& at, Random& random)
{
    const double dry = 0.5 + 0.25 * maths::sin(0.9 * at.x + 1.7 * maths::sin(0.6 * at.y)) +
                       0.25 * maths::sin(1.3 * at.y - 0.8 * at.x);
    const double bright = random.range(0.72, 0.97),
                 yellow = std::clamp(dry * random.range(0.3, 1.2), 0.0, 1.0);
    const glm::dvec3 tone = glm::mix(glm::dvec3(0.80, 0.95, 0.80), glm::dvec3(1.0, 0.97, 0.84), yellow);
    return {glm::u8vec3(glm::clamp(bright * tone, 0.0, 1.0) * 255.0), 255};
}

MeshCopy lying(const glm::dvec3& place, const glm::dquat& turn, double size, const glm::u8vec4& tint)
{
    const glm::quat q(turn);
    return {glm::vec3(place), float(size), {q.x, q.y, q.z, q.w}, noIndex, tint};
}

glm::dquat turned(double angle, const glm::dvec3& axis)
{
    const auto [sine, cosine] = maths::sincos(0.5 * angle);
    return {cosine, sine * axis.x, sine * axis.y, sine * axis.z};
}

void measure(MeshCopies& made, double largest)
{
    made.reach = float(largest * 2.0 * meshBox(made.shape).radius());
}

/// The farthest that most leaves are from the trunk.
double crownRadius(const Foliage& foliage, const glm::dvec3& foot)
{
    std::vector<double> away;
    const std::size_t step = 1 + foliage.leaves.size() / 512;
    for (std::size_t i = 0; i < foliage.leaves.size(); i += step) {
        const glm::dvec3 at = foliage.leaves[i].position - foot;
        away.push_back(std::hypot(at.x, at.z));
    }
    if (away.empty())
        return 0.0;
    const auto most = away.begin() + std::ptrdiff_t(away.size() * 9 / 10);
    std::ranges::nth_element(away, most);
    return *most;
}

} // namespace

MeshCopies grassAround(const std::vector<Foot>& feet, const HeightOfGround& height)
{
    MeshCopies made;
    std::vector<Foot> standing;
    std::ranges::copy_if(feet, std::back_inserter(standing),
                         [](const Foot& foot) { return foot.reach >= leastReach; });
    std::ranges::stable_sort(standing, std::greater(), &Foot::reach);
    standing.resize(std::min(standing.size(), mostFeet));
    const std::size_t most = standing.empty() ? 0 : mostTufts / standing.size();
    for (std::size_t f = 0; f < standing.size(); ++f) {
        const Foot& foot = standing[f];
        const double radius = std::min(ofReach * foot.reach + more, std::max(widest, 3.0 * foot.reach));
        const auto count = std::min(most, std::size_t(tuftsOfArea * pi * radius * radius));
        Random random(1, RandomStream::Terrain, f);
        for (std::size_t i = 0; i < count; ++i) {
            // As many at every distance: dense near the foot, ever sparser until there are none.
            const double away = radius * std::pow(random.unit(), 0.6);
            const auto [sine, cosine] = maths::sincos(fullTurn * random.unit());
            const glm::dvec2 at(foot.place.x + away * cosine, foot.place.z + away * sine);
            const double turn = fullTurn * random.unit(), tall = random.range(0.6, 1.25);
            const glm::u8vec4 tint = tintOfGrass(at, random);
            const double grown = smoothStep(0.95, 2.1, away / foot.reach), left = 1.0 - away / radius;
            if (random.unit() > grown * left)
                continue;
            made.copies.push_back(lying({at.x, height(at), at.y}, turned(turn, {0.0, 1.0, 0.0}),
                                        tall * (0.5 + 0.5 * left), tint));
        }
    }
    addTuft(made, 13, 3, 1.0, LeafDetail::All);
    addTuft(made, 7, 1, 2.0, LeafDetail::Few);
    addTuft(made, 3, 1, 4.5, LeafDetail::Least);
    measure(made, 1.25);
    return made;
}

MeshCopies fallenLeaves(const Foliage& foliage, const Foliage& placed, double alpha, const Foot& foot,
                        const HeightOfGround& height)
{
    // Shares that lie there: of this year, of the last where all have fallen, and for years. Worms and wind
    // take leaves over winter.
    constexpr double ofShed = 0.6, ofLast = 0.35, ofHanging = 0.01;
    MeshCopies made;
    LeafForm form = foliage.form;
    if (form.shape == LeafShape::Faithful || leafRow(form.shape).evergreen ||
        leafRow(form.shape).family == LeafFamily::Shoot)
        return made;
    const auto perShoot = double(form.perShoot);
    form.perShoot = 1;
    form.detail = 1;
    const double reach = std::max(crownRadius(placed, foot.place), 2.0 * foot.reach);
    const double shed = ofShed * double(foliage.shed - foliage.toCome),
                 last = ofLast * double(foliage.toCome);
    const auto fresh = std::min(std::size_t(perShoot * (shed + last)), mostLeaves);
    const double oldShare = last / std::max(shed + last, 1.0);
    const auto kept = std::min(std::size_t(ofHanging * double(leafCount(foliage))), mostLeaves / 4);
    const bool isKnown = foliage.fallenColour != glm::vec3(0.0f);
    const glm::dvec3 autumn(isKnown ? foliage.fallenColour : glm::vec3(leafRow(form.shape).autumn)),
        old(115.0, 92.0, 75.0); // litter, by its pigments
    const glm::dvec3 brightest(fallenMaterial().colour);
    Random random(2, RandomStream::Terrain);
    for (std::size_t i = 0; i < fresh + kept; ++i) {
        const bool isFresh = i < fresh, isOld = !isFresh || double(i) < oldShare * double(fresh);
        const double away = (isFresh ? 1.15 * reach : 2.4 * foot.reach) * std::sqrt(random.unit());
        const auto [sine, cosine] = maths::sincos(fullTurn * random.unit());
        const glm::dvec2 at(foot.place.x + away * cosine, foot.place.z + away * sine);
        const glm::dvec3 tone =
            glm::mix(autumn, old, (isOld ? 0.85 : 0.0) + (isOld ? 0.15 : 0.7) * random.unit());
        const glm::dvec3 tint = glm::clamp(random.range(0.75, 1.0) * tone / brightest, 0.0, 1.0);
        const glm::dquat flat = turned(-0.5 * pi, {1.0, 0.0, 0.0});
        const glm::dquat tilt = turned(random.range(-0.45, 0.45), {1.0, 0.0, 0.0}) *
                                turned(random.range(-0.45, 0.45), {0.0, 0.0, 1.0});
        const double over = random.unit() < 0.5 ? pi : 0.0;
        const double up = random.range(0.012, isFresh ? 0.045 : 0.02); // on the grass, on the litter
        made.copies.push_back(lying({at.x, height(at) + up, at.y},
                                    turned(fullTurn * random.unit(), {0.0, 1.0, 0.0}) * tilt * flat *
                                        turned(over, {0.0, 1.0, 0.0}),
                                    random.range(0.75, 1.1), {glm::u8vec3(tint * 255.0), 255}));
    }
    made.shape = oneLeaf(form, alpha, FoliageModel::Fine);
    made.shape.colours.clear(); // the tint alone counts
    made.detail.fill({0, made.shape.faceCount()});
    made.colours.assign(made.shape.positions.size(), glm::u8vec4(255));
    measure(made, 1.1);
    return made;
}

Material grassMaterial()
{
    Material grass;
    grass.name = "grass";
    grass.colour = {146, 186, 120};
    return grass;
}

Material fallenMaterial()
{
    Material leaves;
    leaves.name = "fallen leaves";
    leaves.colour = {235, 200, 120};
    leaves.twoSided = true;
    return leaves;
}

} // namespace ramure
