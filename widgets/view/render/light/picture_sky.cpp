#include "widgets/view/render/light/picture_sky.h"

#include "core/io/light_picture.h"
#include "core/math/angle.h"
#include "widgets/view/render/light/sky.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <utility>

namespace ramure {
namespace {

constexpr int searchedWidth = 1024, restWidth = 64;

double brightnessOf(const glm::dvec3& colour)
{
    return glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), colour);
}

/// Three numbers of nine bits and the exponent that they share.
std::uint32_t packed(const glm::vec3& colour)
{
    constexpr float most = 65408.0f;
    constexpr int bits = 9, bias = 15;
    const glm::vec3 c = glm::min(colour, glm::vec3(most));
    int exponent = 0;
    (void)std::frexp(std::max({c.r, c.g, c.b, 1e-9f}), &exponent);
    exponent = std::max(exponent, -bias);
    float scale = std::ldexp(1.0f, bits - exponent);
    if (std::max({c.r, c.g, c.b}) * scale >= 511.5f) {
        ++exponent;
        scale *= 0.5f;
    }
    const glm::uvec3 whole(c * scale + 0.5f);
    return whole.r | whole.g << 9 | whole.b << 18 | std::uint32_t(exponent + bias) << 27;
}

/// Small pictures of a large one: means of its pixels.
class Means
{
public:
    void begin(int width)
    {
        m_width = width;
        m_sums.assign(std::size_t(width) * std::size_t(width / 2), glm::dvec4(0.0));
    }
    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_width / 2; }
    /// \param x, y in a picture of this width
    void add(int x, int y, int fromWidth, const glm::dvec3& colour)
    {
        const auto column = std::int64_t(x) * m_width / fromWidth,
                   row = std::int64_t(y) * m_width / fromWidth;
        m_sums[std::size_t(row * m_width + column)] += glm::dvec4(colour, 1.0);
    }
    [[nodiscard]] std::vector<glm::dvec3> colours() const
    {
        std::vector<glm::dvec3> means;
        means.reserve(m_sums.size());
        for (const glm::dvec4& sum : m_sums)
            means.push_back(glm::dvec3(sum) / std::max(sum.w, 1.0));
        return means;
    }

private:
    int m_width = 0;
    std::vector<glm::dvec4> m_sums;
};

/// The picture that is searched for a sun.
struct Searched
{
    int width;
    std::vector<glm::dvec3> colours;

    [[nodiscard]] glm::dvec3 direction(std::size_t i) const
    {
        const std::size_t column = i % std::size_t(width), row = i / std::size_t(width);
        return directionInPicture({(double(column) + 0.5) / width, 2.0 * (double(row) + 0.5) / width});
    }
    /// How much of the whole sphere a pixel is, sr.
    [[nodiscard]] double angle(std::size_t i) const
    {
        const std::size_t row = i / std::size_t(width);
        const double side = fullTurn / width;
        return side * side * std::sin((double(row) + 0.5) * side);
    }
};

/// \param reach cosine of how far around \p middle the light counts
glm::dvec3 centreOfLight(const Searched& in, const glm::dvec3& middle, double reach)
{
    glm::dvec3 sum = 1e-9 * middle;
    for (std::size_t i = 0; i < in.colours.size(); ++i)
        if (const glm::dvec3 way = in.direction(i); glm::dot(way, middle) > reach)
            sum += in.angle(i) * brightnessOf(in.colours[i]) * way;
    return glm::normalize(sum);
}

/// Takes the sun out of the picture: its light, its direction, and the spot itself.
void takeSun(Searched& in, PictureSky& out)
{
    const double reach = std::cos(3.0 * oneDegree), around = std::cos(4.5 * oneDegree);
    const auto end = in.colours.begin() + std::ptrdiff_t(in.colours.size() / 2); // the horizon
    const auto brightest = std::max_element(in.colours.begin(), end, [](const auto& a, const auto& b) {
        return brightnessOf(a) < brightnessOf(b);
    });
    glm::dvec3 middle = in.direction(std::size_t(brightest - in.colours.begin()));
    for (int i = 0; i < 3; ++i) // from the brightest pixel, which may be at the sun's rim
        middle = centreOfLight(in, middle, reach);
    glm::dvec4 ring(0.0);
    std::vector<std::size_t> spot;
    for (std::size_t i = 0; i < in.colours.size(); ++i) {
        const double near = glm::dot(in.direction(i), middle);
        if (near > reach)
            spot.push_back(i);
        else if (near > around)
            ring += in.angle(i) * glm::dvec4(in.colours[i], 1.0);
    }
    const glm::dvec3 beside = glm::dvec3(ring) / std::max(ring.w, 1e-12);
    glm::dvec3 light(0.0), towards(0.0);
    for (const std::size_t i : spot) {
        const glm::dvec3 more = in.angle(i) * glm::max(in.colours[i] - beside, glm::dvec3(0.0));
        light += more;
        towards += brightnessOf(more) * in.direction(i);
        in.colours[i] = glm::min(in.colours[i], beside);
    }
    out.sunlight = light;
    const double lowest = std::sin(leastSunHeightDeg * oneDegree);
    if (glm::length(towards) > 0.0)
        out.sun = glm::normalize(towards);
    if (out.sun.y < lowest) {
        const double level = std::max(std::hypot(out.sun.x, out.sun.z), 1e-9);
        const double across = std::sqrt(1.0 - lowest * lowest) / level;
        out.sun = {out.sun.x * across, lowest, out.sun.z * across};
    }
}

void keepRest(const Searched& in, PictureSky& out)
{
    Means small;
    small.begin(std::min(in.width, restWidth));
    for (std::size_t i = 0; i < in.colours.size(); ++i)
        small.add(int(i % std::size_t(in.width)), int(i / std::size_t(in.width)), in.width, in.colours[i]);
    out.restWidth = small.width();
    out.rest = small.colours();
}

/// A bright cloud, or a window, is no sun: what it gives more than its surroundings makes no shadow.
void lightUp(Searched searched, PictureSky& out)
{
    constexpr double leastShare = 0.05; // of the light of all the rest
    const Searched whole = searched;
    takeSun(searched, out);
    keepRest(searched, out);
    const Ambient ambient = ambientOf([&](const glm::dvec3& way) { return out.restAt(way); });
    const double level = pi * brightnessOf(glm::dvec3(ambientAt(ambient, {0.0f, 1.0f, 0.0f})));
    if (brightnessOf(out.sunlight) >= leastShare * level)
        return;
    out.sunlight = glm::dvec3(0.0);
    out.sun = {0.0, 1.0, 0.0};
    keepRest(whole, out);
}

/// Takes the rows of a file.
class Gathered
{
public:
    Expected<void> begin(int width, int height)
    {
        if (width < 1 || width != 2 * height)
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("%1 x %2 pixels: a picture all around is twice as wide as high"),
                        {std::to_string(width), std::to_string(height)});
        if (width < PictureSky::leastWidth || width > PictureSky::mostWidth)
            return fail(ErrorCode::Limit, RAMURE_NOOP("%1 pixels wide: a picture all around has %2 to %3"),
                        {std::to_string(width), std::to_string(PictureSky::leastWidth),
                         std::to_string(PictureSky::mostWidth)});
        m_width = width;
        m_factor = (width + PictureSky::mostKept - 1) / PictureSky::mostKept;
        m_sky->width = width / m_factor;
        m_sky->height = height / m_factor;
        m_sky->pixels.reserve(std::size_t(m_sky->width) * std::size_t(m_sky->height));
        m_row.assign(std::size_t(m_sky->width), glm::vec3(0.0f));
        m_means.begin(std::min(width, searchedWidth));
        return {};
    }
    Expected<void> add(int y, std::span<const glm::vec3> row)
    {
        for (int x = 0; x < m_width; ++x)
            m_means.add(x, y, m_width, row[std::size_t(x)]);
        for (std::size_t x = 0; x < m_row.size() * std::size_t(m_factor); ++x)
            m_row[x / std::size_t(m_factor)] += row[x] / float(m_factor * m_factor);
        if (y % m_factor != m_factor - 1)
            return {};
        for (glm::vec3& colour : m_row)
            m_sky->pixels.push_back(packed(std::exchange(colour, glm::vec3(0.0f))));
        return {};
    }
    Expected<std::shared_ptr<const PictureSky>> finish(const std::string& path)
    {
        Searched searched{m_means.width(), m_means.colours()};
        if (std::ranges::all_of(searched.colours, [](const auto& c) { return brightnessOf(c) < 1e-12; })) {
            Error error = fail(ErrorCode::Invalid, RAMURE_NOOP("the picture is black")).value();
            error.file = path;
            return fail(std::move(error));
        }
        m_sky->file = path;
        m_sky->pixels.resize(std::size_t(m_sky->width) * std::size_t(m_sky->height));
        lightUp(std::move(searched), *m_sky);
        return m_sky;
    }

private:
    std::shared_ptr<PictureSky> m_sky = std::make_shared<PictureSky>();
    int m_width = 0, m_factor = 1; ///< pixels of the file, a side, that become one
    std::vector<glm::vec3> m_row;
    Means m_means;
};

} // namespace

glm::dvec2 placeInPicture(const glm::dvec3& direction)
{
    const double turn = std::atan2(-direction.z, -direction.x) / fullTurn;
    return {turn - std::floor(turn), 0.5 - std::asin(std::clamp(direction.y, -1.0, 1.0)) / pi};
}

glm::dvec3 directionInPicture(const glm::dvec2& place)
{
    const double up = pi * (0.5 - place.y), turn = fullTurn * place.x;
    return {-std::cos(up) * std::cos(turn), std::sin(up), -std::cos(up) * std::sin(turn)};
}

glm::dvec3 PictureSky::restAt(const glm::dvec3& direction) const
{
    const glm::dvec2 place = placeInPicture(direction);
    const int x = std::clamp(int(place.x * restWidth), 0, restWidth - 1);
    const int y = std::clamp(int(place.y * 0.5 * restWidth), 0, restWidth / 2 - 1);
    return rest[std::size_t(y) * std::size_t(restWidth) + std::size_t(x)];
}

Expected<std::shared_ptr<const PictureSky>> readPictureSky(const std::string& path, const Progress& progress)
{
    Gathered gathered;
    RAMURE_TRY(readLightPicture(path,
                                {[&](int width, int height) { return gathered.begin(width, height); },
                                 [&](int y, std::span<const glm::vec3> row) { return gathered.add(y, row); }},
                                progress));
    return gathered.finish(path);
}

} // namespace ramure
