#include "core/scatter/scatter.h"

#include "core/base/parallel.h"
#include "core/io/grey_picture.h"
#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include "core/math/stage_hash.h"
#include "core/params/source_facts.h"
#include "core/scatter/scatter_ground.h"
#include "core/scatter/stand_places.h"
#include "core/scene/kinds/node_kinds.h"
#include "core/scene/object_mesh.h"
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <glm/matrix.hpp>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>

namespace ramure {
namespace {

constexpr std::string_view separators = " \t\n,;";

tl::unexpected<Error> wrong(const char* key, ErrorCode code, const char* text, const std::string& arg = {})
{
    auto error = fail(code, text, {arg});
    error.value().path = key;
    return error;
}

/// Numbers of a text, between blanks, commas or semicolons. \param read makes a number of a piece of text, or
/// nothing
template <class Number, class Read>
Expected<std::vector<Number>> numbersIn(std::string_view text, const char* key, Read&& read)
{
    std::vector<Number> out;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
        if (text.empty())
            return out;
        const std::string_view piece = text.substr(0, text.find_first_of(separators));
        const std::optional<Number> number = read(piece);
        if (!number)
            return wrong(key, ErrorCode::Syntax, RAMURE_NOOP("“%1” is no number that is possible here"),
                         std::string(piece));
        out.push_back(*number);
        text.remove_prefix(piece.size());
    }
}

/// How often each prototype is taken, summed up: the last is the sum of all.
Expected<std::vector<double>> sharesUpTo(const ScatterParams& params, std::size_t prototypes)
{
    auto shares = numbersIn<double>(
        params.shares, "scatter.shares", [](std::string_view piece) -> std::optional<double> {
            double value = 0.0;
            const auto [end, error] = std::from_chars(piece.data(), piece.data() + piece.size(), value);
            const bool isWhole = error == std::errc() && end == piece.data() + piece.size();
            return isWhole && value >= 0.0 && value <= 1e9 ? std::optional(value) : std::nullopt;
        });
    RAMURE_TRY(shares);
    shares->resize(prototypes, 1.0);
    std::partial_sum(shares->begin(), shares->end(), shares->begin());
    if (!shares->empty() && !(shares->back() > 0.0))
        return wrong("scatter.shares", ErrorCode::Invalid,
                     RAMURE_NOOP("no node below the scatter has a share above 0"));
    return shares;
}

Expected<std::set<std::uint32_t>> removedKeys(const ScatterParams& params)
{
    const auto keys = numbersIn<std::uint32_t>(
        params.removed, "scatter.removed", [](std::string_view piece) -> std::optional<std::uint32_t> {
            std::uint32_t key = 0;
            const auto [end, error] = std::from_chars(piece.data(), piece.data() + piece.size(), key, 16);
            return error == std::errc() && end == piece.data() + piece.size() ? std::optional(key)
                                                                              : std::nullopt;
        });
    RAMURE_TRY(keys);
    return std::set(keys->begin(), keys->end());
}

/// Gather in clusters: soft noise between the corners of cells.
double clusterAt(const ScatterParams& params, double x, double z)
{
    const double u = x / params.clusterSize, v = z / params.clusterSize;
    const auto eased = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const auto corner = [&](double column, double row) {
        const auto key = mixBits(static_cast<std::uint64_t>(static_cast<std::int64_t>(column))) ^
                         static_cast<std::uint64_t>(static_cast<std::int64_t>(row));
        return Random(static_cast<std::uint64_t>(params.seed), RandomStream::Clusters, key).unit();
    };
    const double c = std::floor(u), r = std::floor(v), s = eased(u - c), t = eased(v - r);
    const double low = std::lerp(corner(c, r), corner(c + 1.0, r), s);
    const double high = std::lerp(corner(c, r + 1.0), corner(c + 1.0, r + 1.0), s);
    return eased(std::clamp((std::lerp(low, high, t) - 0.42) / 0.2, 0.0, 1.0));
}

/// What decides whether a copy may stand at a place, but for the other copies.
struct Rules
{
    const ScatterParams& params;
    bool hasGround = false;
    SurfaceFromAbove ground{}, obstacles{};
    std::optional<GreyPicture> density{};

    /// Nothing where none may stand. \param chance 0 .. 1
    [[nodiscard]] std::optional<SurfaceFromAbove::Place> at(double x, double z, double chance) const
    {
        double share = 1.0;
        if (density)
            share = std::clamp(density->at(x / params.width + 0.5, z / params.depth + 0.5), 0.0, 1.0);
        if (params.clusters > 0.0)
            share *= std::lerp(1.0, clusterAt(params, x, z), params.clusters);
        if (!(chance < share))
            return std::nullopt;
        const auto place = hasGround ? ground.at(x, z) : std::optional(SurfaceFromAbove::Place());
        if (!place || place->height < params.lowest || place->height > params.highest ||
            maths::acos(std::clamp(place->normal.y, -1.0, 1.0)) > params.steepest)
            return std::nullopt;
        if (!obstacles.empty() && obstacles.isNear(x, z, params.clearance))
            return std::nullopt;
        return place;
    }
};

Expected<Rules> rulesOf(const Scene& scene, const Node& scatter)
{
    Rules rules{scatter.params.scatter};
    const auto grounds = groundsOf(scene, scatter);
    RAMURE_TRY(grounds);
    rules.hasGround = !grounds->empty();
    auto ground = SurfaceFromAbove::of(scene, scatter, *grounds);
    RAMURE_TRY(ground);
    rules.ground = std::move(*ground);
    auto obstacles = SurfaceFromAbove::of(scene, scatter, obstaclesOf(scene, *grounds));
    RAMURE_TRY(obstacles);
    rules.obstacles = std::move(*obstacles);
    if (!rules.params.density.empty()) {
        auto picture = readGreyPicture(rules.params.density);
        if (!picture) {
            picture.error().path = "scatter.density";
            return fail(picture.error());
        }
        rules.density.emplace(std::move(*picture));
    }
    return rules;
}

/// Finds whether a point is nearer to another one than the spacing. The points of a cell, and of others that
/// share its bucket by chance, are a chain.
class Spaced
{
public:
    Spaced(double spacing, std::size_t expected)
        : m_spacing(spacing)
        , m_first(std::bit_ceil(2 * expected + 16), noIndex)
    {
    }
    /// False: it is too near to another, and not added.
    bool add(const glm::dvec2& point)
    {
        if (!(m_spacing > least))
            return true;
        const double column = std::floor(point.x / m_spacing), row = std::floor(point.y / m_spacing);
        for (const double x : {column - 1.0, column, column + 1.0})
            for (const double y : {row - 1.0, row, row + 1.0})
                if (isTaken(m_first[bucket(x, y)], point))
                    return false;
        Index& first = m_first[bucket(column, row)];
        m_next.push_back(std::exchange(first, static_cast<Index>(m_points.size())));
        m_points.push_back(point);
        return true;
    }

private:
    [[nodiscard]] bool isTaken(Index at, const glm::dvec2& point) const
    {
        for (; at != noIndex; at = m_next[at]) {
            const glm::dvec2 apart = m_points[at] - point;
            if (apart.x * apart.x + apart.y * apart.y < m_spacing * m_spacing)
                return true;
        }
        return false;
    }
    [[nodiscard]] std::size_t bucket(double column, double row) const
    {
        const auto word = [](double number) {
            return static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
        };
        return mixBits(mixBits(word(column)) + word(row)) & (m_first.size() - 1);
    }

    static constexpr double least = 1e-6; ///< m: less is none, and numbers of cells stay whole numbers

    double m_spacing;
    std::vector<Index> m_first, m_next;
    std::vector<glm::dvec2> m_points;
};

/// One throw at the area: where it fell, and what the rules say of it.
struct Throw
{
    glm::dvec2 at{0.0};
    std::optional<SurfaceFromAbove::Place> place;
};

Throw throwOf(const Rules& rules, std::uint32_t key)
{
    const ScatterParams& params = rules.params;
    Random random(static_cast<std::uint64_t>(params.seed), RandomStream::Scatter, key);
    const double x = random.range(-0.5, 0.5) * params.width, z = random.range(-0.5, 0.5) * params.depth;
    return {{x, z}, rules.at(x, z, random.unit())};
}

ScatterPlace placeOf(const Throw& thrown, std::uint32_t key, const ScatterParams& params,
                     const std::vector<double>& shares)
{
    Random random(static_cast<std::uint64_t>(params.seed), RandomStream::ScatterForm, key);
    const auto& [height, normal] = *thrown.place;
    ScatterPlace place;
    place.key = key;
    place.position = {thrown.at.x, height, thrown.at.y};
    place.turn = maths::angleAxis((random.unit() - 0.5) * 2.0 * pi * params.turn, {0.0, 1.0, 0.0});
    const double lean = std::clamp(normal.y, -1.0, 1.0);
    const glm::dvec3 axis(normal.z, 0.0, -normal.x); // up x normal
    if (const double length = maths::hypot(axis.x, axis.z); params.alignment > 0.0 && length > 0.0)
        place.turn = maths::angleAxis(params.alignment * maths::acos(lean), axis / length) * place.turn;
    const double least = maths::log(std::min(params.leastScale, params.mostScale));
    const double most = maths::log(std::max(params.leastScale, params.mostScale));
    place.size = least < most ? maths::exp(random.range(least, most)) : params.leastScale;
    const double drawn = random.unit() * shares.back();
    const auto chosen = std::ranges::upper_bound(shares, drawn);
    place.prototype =
        static_cast<std::uint32_t>(std::min<std::ptrdiff_t>(chosen - shares.begin(), std::ssize(shares) - 1));
    return place;
}

/// How many throws there are at most: so many that the area is as good as full, or that rules which leave a
/// thirtieth of it still give the number.
std::size_t throwsOf(const ScatterParams& params)
{
    const double cells = params.spacing > 0.0
                             ? params.width / params.spacing * (params.depth / params.spacing)
                             : static_cast<double>(params.count);
    const double wanted = params.count > 0 ? std::min(cells, static_cast<double>(params.count)) : cells;
    return static_cast<std::size_t>(std::min(30.0 * wanted + 1000.0, 30.0 * double(mostInstances)));
}

Expected<ScatterPlaces> thrown(const Rules& rules, const std::vector<double>& shares,
                               const Progress& progress)
{
    constexpr std::size_t round = 1 << 16, grain = 1 << 10;
    const ScatterParams& params = rules.params;
    const std::size_t most = params.count > 0 ? std::size_t(params.count) : mostInstances + 1;
    const std::size_t throws = throwsOf(params);
    Spaced spaced(params.spacing, std::min(most, throws / 30));
    ScatterPlaces out;
    std::vector<Throw> hits;
    for (std::size_t from = 0, count = 0; from < throws && out.size() < most; from += count) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        progress.report(double(from) / double(throws));
        // A small number is not looked for in a large round.
        count = std::min({round, throws - from, 4 * (most - out.size()) + 64});
        hits.assign(count, {});
        parallelFor(count, grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                hits[i] = throwOf(rules, static_cast<std::uint32_t>(from + i));
        });
        for (std::size_t i = 0; i < count && out.size() < most; ++i)
            if (hits[i].place && spaced.add(hits[i].at))
                out.push_back(placeOf(hits[i], static_cast<std::uint32_t>(from + i), params, shares));
    }
    if (out.size() > mostInstances)
        return wrong("scatter.count", ErrorCode::Limit,
                     RAMURE_NOOP("over %1 instances: the spacing is too small for this area"),
                     std::to_string(mostInstances));
    return out;
}

void add(StageHash& hash, const glm::dmat4& place)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            hash.add(place[column][row]);
}

} // namespace

glm::dmat4 placeMatrix(const ScatterPlace& place)
{
    glm::dmat4 out = glm::mat4_cast(place.turn);
    for (int i = 0; i < 3; ++i)
        out[i] *= place.size;
    out[3] = glm::dvec4(place.position, 1.0);
    return out;
}

std::vector<const Node*> prototypesOf(const Scene& scene, NodeId scatter)
{
    std::vector<const Node*> found;
    for (const NodeId id : scene.children(scatter))
        if (const Node* node = scene.find(id);
            node->visible && (node->kind == NodeKind::Tree || isShape(node->kind)))
            found.push_back(node);
    return found;
}

glm::dmat4 prototypeMatrix(const Node& prototype)
{
    PlacementParams placement = prototype.params.tree;
    placement.translation = glm::dvec3(0.0);
    return placementMatrix(placement) * placementMatrix(prototype.params.local);
}

Expected<SharedPlaces> scatterPlaces(const Scene& scene, const Node& scatter, const Progress& progress)
{
    const ScatterParams& params = scatter.params.scatter;
    const auto shares = sharesUpTo(params, prototypesOf(scene, scatter.id).size());
    RAMURE_TRY(shares);
    const auto removed = removedKeys(params);
    RAMURE_TRY(removed);
    if (params.count == 0 && !(params.spacing > 0.0))
        return wrong("scatter.count", ErrorCode::Invalid,
                     RAMURE_NOOP("a scatter without a spacing needs a number of instances"));
    if (shares->empty())
        return std::make_shared<const ScatterPlaces>();
    const auto rules = rulesOf(scene, scatter);
    RAMURE_TRY(rules);
    auto places = thrown(*rules, *shares, progress.part(0.0, params.stand ? 0.2 : 1.0));
    RAMURE_TRY(places);
    if (params.stand) {
        places =
            grownPlaces(params, prototypesOf(scene, scatter.id), std::move(*places), progress.part(0.2, 1.0));
        RAMURE_TRY(places);
    }
    // Only now: one that was taken away keeps its place, and no other comes closer for it.
    std::erase_if(*places, [&](const ScatterPlace& place) { return removed->contains(place.key); });
    return std::make_shared<const ScatterPlaces>(std::move(*places));
}

std::uint64_t scatterHash(const Scene& scene, const Node& scatter)
{
    StageHash hash(prototypesOf(scene, scatter.id).size());
    for (const Node* node : prototypesOf(scene, scatter.id))
        if (scatter.params.scatter.stand) // how high they are
            hash.add(std::string_view(node->preset))
                .add(static_cast<int>(node->kind))
                .add(static_cast<int>(node->params.generator.kind))
                .add(node->params.growth.age)
                .add(node->params.growth.height)
                .add(node->kind == NodeKind::Tree ? sourceFacts(node->params).reach(node->params) : 0.0);
    for (const double number : ownNumbers(NodeKind::Scatter, scatter.params))
        hash.add(number);
    const std::string& density = scatter.params.scatter.density;
    if (std::error_code ignored; !density.empty())
        hash.add(std::filesystem::last_write_time(density, ignored).time_since_epoch().count());
    const auto grounds = groundsOf(scene, scatter);
    if (!grounds)
        return hash.add(-1).value();
    const glm::dmat4 into = glm::inverse(worldMatrix(scene, scatter.id));
    for (const auto& solids : {*grounds, obstaclesOf(scene, *grounds)}) {
        hash.add(solids.size());
        for (const Node* node : solids)
            add(hash.add(shapeHash(*node)), into * geometryMatrix(scene, *node));
    }
    return hash.value();
}

Expected<SharedPlaces> ScatterMemory::places(const Scene& scene, const Node& scatter,
                                             const Progress& progress)
{
    const std::uint64_t hash = scatterHash(scene, scatter);
    const std::scoped_lock lock(m_mutex);
    std::erase_if(m_known, [&scene](const Known& known) { return !scene.find(known.node); });
    const auto known = std::ranges::find(m_known, scatter.id, &Known::node);
    if (known != m_known.end() && known->hash == hash)
        return known->places;
    auto places = scatterPlaces(scene, scatter, progress);
    RAMURE_TRY(places);
    if (known != m_known.end())
        *known = {scatter.id, hash, *places};
    else
        m_known.push_back({scatter.id, hash, *places});
    return places;
}

} // namespace ramure
