#include "widgets/view/render/crowd/crowd_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ramure {
namespace {

constexpr double fade = 0.1; ///< about the switch from one form to the next, as a share of its pixels
constexpr double mostCoarser = 4096.0; ///< beyond it all have their last form
constexpr double leastDistance = 1e-6; ///< m

struct Seen
{
    Index place = 0;
    float pixels = 0.0f, distance = 0.0f;
};

std::vector<Seen> seenOf(const Crowd& crowd, const CrowdSight& sight)
{
    std::vector<Seen> seen;
    crowd.bounds().inPlanes(sight.planes, [&](Index at, bool isCertain) {
        const ScatterPlace& place = crowd.places()[at];
        const Box& own = crowd.prototypes()[place.prototype].box;
        if (!isCertain) { // the hierarchy knows groups of places
            const Box box = crowd.boxOf(place);
            const glm::dvec3 middle = box.centre(), half = 0.5 * box.size();
            for (const CutPlane& plane : sight.planes)
                if (glm::dot(glm::dvec3(plane), middle) + plane.w +
                        glm::dot(glm::abs(glm::dvec3(plane)), half) <
                    0.0)
                    return;
        }
        const glm::dvec3 middle = place.position + place.turn * (place.size * own.centre());
        const double distance = std::max(glm::distance(middle, sight.eye), leastDistance);
        const double high = place.size * std::max({own.size().x, own.size().y, own.size().z});
        seen.push_back(
            {at, float(high * sight.pixels / (sight.isParallel ? 1.0 : distance)), float(distance)});
    });
    return seen;
}

/// How many of a prototype have about so many pixels.
class Census
{
public:
    explicit Census(const Crowd& crowd)
        : m_crowd(crowd)
        , m_counts(crowd.prototypes().size())
    {
    }
    void add(const ScatterPlace& place, double pixels) { ++m_counts[place.prototype][binOf(pixels)]; }
    [[nodiscard]] double triangles(double coarser) const
    {
        double sum = 0.0;
        for (std::size_t p = 0; p < m_counts.size(); ++p) {
            const std::vector<CrowdForm>& forms = m_crowd.prototypes()[p].forms;
            std::size_t form = 0;
            for (std::size_t bin = bins; bin-- > 0 && !forms.empty();) {
                const double pixels = std::exp2((double(bin) + 0.5) / perOctave - octavesBelow) / coarser;
                while (form + 1 < forms.size() && pixels < forms[form].leastPixels)
                    ++form;
                sum += double(m_counts[p][bin]) * double(forms[form].triangles);
            }
        }
        return sum;
    }

private:
    static constexpr double perOctave = 4.0, octavesBelow = 4.0;
    static constexpr std::size_t bins = 96;
    static std::size_t binOf(double pixels)
    {
        const double at = (std::log2(std::max(pixels, 1e-9)) + octavesBelow) * perOctave;
        return std::size_t(std::clamp(at, 0.0, double(bins - 1)));
    }
    const Crowd& m_crowd;
    std::vector<std::array<std::size_t, bins>> m_counts;
};

/// Takes those out that are drawn whole. \pre sorted by their pixels, most first
std::vector<Index> takeWhole(const Crowd& crowd, std::vector<Seen>& seen, const CrowdBudget& budget,
                             std::int64_t& triangles)
{
    std::vector<Index> whole;
    std::int64_t left = budget.whole;
    std::erase_if(seen, [&](const Seen& one) {
        const std::int64_t own = crowd.prototypes()[crowd.places()[one.place].prototype].wholeTriangles;
        if (own <= 0 || own > left || double(one.pixels) < budget.wholePixels)
            return false;
        left -= own;
        whole.push_back(one.place);
        return true;
    });
    triangles += budget.whole - left;
    return whole;
}

} // namespace

CrowdChoice chooseForms(const Crowd& crowd, const CrowdSight& sight, const CrowdBudget& budget)
{
    CrowdChoice choice;
    std::vector<Seen> seen = seenOf(crowd, sight);
    choice.instances = seen.size();
    // What is near hides what is behind it.
    std::ranges::sort(seen, [](const Seen& a, const Seen& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.place < b.place;
    });
    choice.whole = takeWhole(crowd, seen, budget, choice.triangles);
    Census census(crowd);
    for (const Seen& one : seen)
        census.add(crowd.places()[one.place], one.pixels);
    double coarser = budget.coarser;
    while (coarser < mostCoarser && census.triangles(coarser) > double(budget.triangles))
        coarser *= 1.15;
    std::vector<std::vector<std::vector<MeshCopy>>> copies;
    for (const CrowdPrototype& prototype : crowd.prototypes())
        copies.emplace_back(prototype.forms.size());
    const auto put = [&](const ScatterPlace& place, std::size_t form, std::uint8_t shown) {
        copies[place.prototype][form].push_back(copyOf(place, crowd.prototypes()[place.prototype], shown));
        choice.triangles += crowd.prototypes()[place.prototype].forms[form].triangles;
    };
    for (const Seen& one : seen) {
        const ScatterPlace& place = crowd.places()[one.place];
        const std::vector<CrowdForm>& forms = crowd.prototypes()[place.prototype].forms;
        const double pixels = double(one.pixels) / coarser;
        std::size_t form = 0;
        while (form + 1 < forms.size() && pixels < (1.0 - fade) * forms[form].leastPixels)
            ++form;
        const double least = forms[form].leastPixels;
        const double share = least > 0.0 ? (pixels - (1.0 - fade) * least) / (2.0 * fade * least) : 1.0;
        if (share >= 1.0 || form + 1 == forms.size()) {
            put(place, form, 255);
            continue;
        }
        const auto step = std::uint8_t(std::lround(share * 126.0));
        put(place, form, step);
        put(place, form + 1, std::uint8_t(128 + step));
    }
    for (std::size_t p = 0; p < copies.size(); ++p)
        for (std::size_t f = 0; f < copies[p].size(); ++f)
            if (!copies[p][f].empty())
                choice.forms.push_back(
                    {p, f, std::make_shared<const std::vector<MeshCopy>>(std::move(copies[p][f]))});
    return choice;
}

} // namespace ramure
