#include "core/generators/colonisation/crown_shape.h"

#include "core/base/number_text.h"
#include "core/generators/colonisation/growth_space.h"
#include "core/generators/parametric/text_scanner.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ramure {
namespace {

constexpr const char* profileKey = "colonisation.profile";

Expected<double> takeShare(TextScanner& text)
{
    const TextPlace place = text.place();
    if (!text.atNumber())
        return failAt(place, ErrorCode::Syntax, RAMURE_NOOP("a number was expected here"));
    const auto number = text.takeNumber();
    if (number && *number > 1.0)
        return failAt(place, ErrorCode::Invalid,
                      RAMURE_NOOP("heights and radii of a profile are shares from 0 to 1"));
    return number;
}

/// By Fritsch and Carlson, with the limiter that keeps each slope within three times those beside it.
std::vector<double> monotoneSlopes(const std::vector<glm::dvec2>& pairs)
{
    const std::size_t pieces = pairs.size() - 1;
    std::vector<double> rise(pieces), slopes(pairs.size());
    for (std::size_t i = 0; i < pieces; ++i)
        rise[i] = (pairs[i + 1].y - pairs[i].y) / (pairs[i + 1].x - pairs[i].x);
    slopes.front() = rise.front();
    slopes.back() = rise.back();
    for (std::size_t i = 1; i < pieces; ++i)
        slopes[i] = rise[i - 1] * rise[i] > 0.0 ? 0.5 * (rise[i - 1] + rise[i]) : 0.0;
    for (std::size_t i = 0; i < pieces; ++i) {
        const double most = 3.0 * std::abs(rise[i]);
        slopes[i] = std::clamp(slopes[i], -most, most);
        slopes[i + 1] = std::clamp(slopes[i + 1], -most, most);
    }
    return slopes;
}

} // namespace

Expected<std::vector<glm::dvec2>> parseProfile(std::string_view text)
{
    TextScanner scanner(text, profileKey, 1, true);
    std::vector<glm::dvec2> pairs;
    while (true) {
        const TextPlace place = scanner.place();
        const auto height = takeShare(scanner);
        RAMURE_TRY(height);
        const auto radius = takeShare(scanner);
        RAMURE_TRY(radius);
        if (!pairs.empty() && *height <= pairs.back().x)
            return failAt(place, ErrorCode::Invalid,
                          RAMURE_NOOP("each height must be greater than the one before"));
        pairs.emplace_back(*height, *radius);
        if (pairs.size() > maxProfilePairs)
            return failAt(place, ErrorCode::Limit, RAMURE_NOOP("a profile has at most %1 pairs"),
                          {std::to_string(maxProfilePairs)});
        if (scanner.atEnd())
            break;
        if (!scanner.take(","))
            return failAt(scanner.place(), ErrorCode::Syntax,
                          RAMURE_NOOP("a comma was expected between two pairs"));
    }
    if (pairs.size() < 2)
        return failAt(scanner.place(), ErrorCode::Invalid, RAMURE_NOOP("a profile needs two pairs or more"));
    if (std::ranges::all_of(pairs, [](const glm::dvec2& pair) { return pair.y == 0.0; }))
        return failAt(scanner.place(), ErrorCode::Invalid,
                      RAMURE_NOOP("a profile must be wider than nothing somewhere"));
    return pairs;
}

std::string profileText(const std::vector<glm::dvec2>& pairs)
{
    std::string text;
    for (const glm::dvec2& pair : pairs)
        text += (text.empty() ? "" : ", ") + numberText(pair.x) + ' ' + numberText(pair.y);
    return text;
}

Expected<CrownOutline> CrownOutline::of(const ColonisationParams& params)
{
    CrownOutline outline;
    outline.m_envelope = params.envelope;
    if (params.envelope != CrownEnvelope::Profile)
        return outline;
    return parseProfile(params.profile).map([](std::vector<glm::dvec2>&& pairs) {
        return *through(std::move(pairs));
    });
}

std::optional<CrownOutline> CrownOutline::through(std::vector<glm::dvec2> pairs)
{
    const auto isBad = [](const glm::dvec2& pair) {
        return !(pair.x >= 0.0 && pair.x <= 1.0 && pair.y >= 0.0 && pair.y <= 1.0);
    };
    const bool ascends =
        std::ranges::adjacent_find(pairs, std::ranges::greater_equal(), &glm::dvec2::x) == pairs.end();
    if (pairs.size() < 2 || pairs.size() > maxProfilePairs || !ascends || std::ranges::any_of(pairs, isBad) ||
        std::ranges::max(pairs, {}, &glm::dvec2::y).y == 0.0)
        return std::nullopt;
    CrownOutline outline;
    outline.m_envelope = CrownEnvelope::Profile;
    outline.m_pairs = std::move(pairs);
    outline.m_slopes = monotoneSlopes(outline.m_pairs);
    return outline;
}

double CrownOutline::widest() const
{
    return m_pairs.empty() ? 1.0 : std::ranges::max_element(m_pairs, {}, &glm::dvec2::y)->y;
}

double CrownOutline::radiusAt(double height) const
{
    if (height < 0.0 || height > 1.0)
        return 0.0;
    switch (m_envelope) {
    case CrownEnvelope::Sphere:
        return 2.0 * std::sqrt(height * (1.0 - height));
    case CrownEnvelope::Hemisphere:
        return std::sqrt(1.0 - height * height);
    case CrownEnvelope::Cone:
        return 1.0 - height;
    case CrownEnvelope::Cylinder:
        return 1.0;
    case CrownEnvelope::Solid:
        return 0.0;
    case CrownEnvelope::Profile:
        break;
    }
    const auto above = std::ranges::upper_bound(m_pairs, height, {}, &glm::dvec2::x);
    if (above == m_pairs.begin())
        return 0.0;
    const auto i = static_cast<std::size_t>(above - m_pairs.begin()) - 1;
    if (above == m_pairs.end())
        return height == m_pairs[i].x ? m_pairs[i].y : 0.0;
    const double width = above->x - m_pairs[i].x, t = (height - m_pairs[i].x) / width, left = 1.0 - t;
    return (1.0 + 2.0 * t) * left * left * m_pairs[i].y + t * left * left * width * m_slopes[i] +
           t * t * (3.0 - 2.0 * t) * above->y - t * t * left * width * m_slopes[i + 1];
}

namespace {

Expected<std::vector<glm::dvec3>> revolvedPoints(const ColonisationParams& params, std::uint64_t seed)
{
    const auto outline = CrownOutline::of(params);
    RAMURE_TRY(outline);
    std::vector<glm::dvec3> points;
    points.reserve(static_cast<std::size_t>(params.points));
    for (std::int64_t i = 0; i < params.points; ++i) {
        Random random(seed, RandomStream::CrownPoints, std::uint64_t(i));
        double height = random.unit();
        // Evenly in the volume: a height is as likely as its disc is large. A profile that is a needle but
        // for one place may use up its tries; its point stands where the last one fell.
        for (int tries = 0; tries < 1000; ++tries, height = random.unit()) {
            const double share = outline->radiusAt(height) / outline->widest();
            if (random.unit() < share * share)
                break;
        }
        const double aside = params.crownRadius * outline->radiusAt(height) *
                             maths::pow(random.unit(), 0.5 * (1.0 - params.surface));
        const auto [sine, cosine] = maths::sincos(2.0 * std::numbers::pi * random.unit());
        points.emplace_back(aside * cosine, params.crownBase + params.crownHeight * height, aside * sine);
    }
    return points;
}

Expected<std::vector<glm::dvec3>> solidPoints(const ColonisationParams& params, std::uint64_t seed,
                                              const Progress& progress)
{
    const GrowthSpace nothing({});
    const GrowthSpace& space = params.space.space() ? *params.space.space() : nothing;
    RAMURE_TRY(space.checkEnvelope());
    return space.points(params.points, params.surface, seed, progress);
}

} // namespace

Expected<std::vector<glm::dvec3>> crownPoints(const ColonisationParams& params, std::uint64_t seed,
                                              const Progress& progress)
{
    auto points = params.envelope == CrownEnvelope::Solid ? solidPoints(params, seed, progress)
                                                          : revolvedPoints(params, seed);
    if (!points || !params.space.space())
        return points;
    std::erase_if(*points, [&](const glm::dvec3& point) {
        return !progress.cancelled() && params.space.space()->blocks(point);
    });
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    if (!points->empty())
        return points;
    auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("the obstacles leave no room for the crown"));
    error.value().path = "colonisation.envelope";
    return error;
}

} // namespace ramure
