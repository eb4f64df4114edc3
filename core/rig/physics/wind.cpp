#include "core/rig/physics/wind.h"

#include "core/math/angle.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// What a wave is before chance changes it.
struct WaveKind
{
    double hertz;
    double share;      ///< of the mean wind
    double wavelength; ///< of turbulence, in tree heights
};
constexpr WaveKind kinds[WindField::waves] = {{0.11, 0.6, 0.0}, {0.29, 0.4, 0.0},  {0.7, 0.5, 0.9},
                                              {1.3, 0.4, 0.5},  {2.3, 0.35, 0.35}, {3.7, 0.3, 0.2}};

glm::dvec3 towards(double directionRad)
{
    const auto [sine, cosine] = maths::sincos(directionRad);
    return {cosine, 0.0, -sine};
}

glm::dvec3 randomDirection(Random& random)
{
    const double y = random.range(-1.0, 1.0), angle = random.range(0.0, fullTurn);
    const double r = std::sqrt(1.0 - y * y);
    const auto [sine, cosine] = maths::sincos(angle);
    return {r * cosine, y, r * sine};
}

} // namespace

glm::dvec3 faithfulWind(const PhysicsParams& params, double t)
{
    constexpr double shift = 56485.0;
    const double u = 4.0 * maths::sin(t) + 2.0 * maths::sin(2.5 * t) + 0.4 * maths::sin(5.0 * t);
    const double v =
        4.0 * maths::cos(t + shift) + 2.0 * maths::cos(2.5 * t + shift) + 0.4 * maths::cos(5.0 * t + shift);
    const auto [s, c] = maths::sincos(params.windDirection);
    return params.windStrength * glm::dvec3(u * c + v * s, 0.0, v * c - u * s);
}

void WindField::setPhases(const TreeBody& body)
{
    m_slots = body.size();
    m_sin.resize(std::size_t(waves) * m_slots);
    m_cos.resize(std::size_t(waves) * m_slots);
    double height = 1e-6;
    for (const double reach : body.reach)
        height = std::max(height, reach);
    for (int w = 0; w < waves; ++w) {
        const WaveKind& kind = kinds[w];
        Wave& wave = m_waves[std::size_t(w)];
        Random random(static_cast<std::uint64_t>(m_seed), RandomStream::Wind, std::uint64_t(w));
        wave.pulsation = fullTurn * kind.hertz * random.range(0.8, 1.25);
        const glm::dvec3 way = randomDirection(random);
        wave.direction = randomDirection(random);
        wave.phase = random.range(0.0, fullTurn);
        // Gusts walk through the tree with the wind, eddies in any direction.
        wave.waveVector = w < gustWaves ? wave.pulsation / robustWindSpeed * towards(m_directionRad)
                                        : fullTurn / (kind.wavelength * height) * way;
        for (Index slot = 0; slot < body.size(); ++slot) {
            const double at = glm::dot(wave.waveVector, 0.5 * (body.p0[slot] + body.p1[slot])) + wave.phase;
            const auto [sine, cosine] = maths::sincos(at);
            m_sin[std::size_t(w) * m_slots + slot] = sine;
            m_cos[std::size_t(w) * m_slots + slot] = cosine;
        }
    }
}

void WindField::setParams(const TreeBody& body, const PhysicsParams& params)
{
    if (!m_hasPhases || params.seed != m_seed || params.windDirection != m_directionRad) {
        m_seed = params.seed;
        m_directionRad = params.windDirection;
        setPhases(body);
        m_hasPhases = true;
    }
    const double speed = params.windStrength * robustWindSpeed;
    const glm::dvec3 along = towards(params.windDirection);
    m_mean = speed * along;
    for (int w = 0; w < waves; ++w) {
        Wave& wave = m_waves[std::size_t(w)];
        wave.amplitude = w < gustWaves ? params.windGust * kinds[w].share * speed * along
                                       : params.windTurbulence * kinds[w].share * speed * wave.direction;
    }
}

WindField::Moment WindField::at(double t) const
{
    Moment moment;
    moment.mean = m_mean;
    for (std::size_t w = 0; w < waves; ++w) {
        const auto [sine, cosine] = maths::sincos(m_waves[w].pulsation * t);
        moment.sine[w] = m_waves[w].amplitude * cosine;
        moment.cosine[w] = m_waves[w].amplitude * -sine;
    }
    return moment;
}

WindField::Moment WindField::felt(double t, double rate, double ratio) const
{
    Moment moment;
    moment.mean = m_mean;
    for (std::size_t w = 0; w < waves; ++w) {
        // 1 / (1 - r² + 2 i ratio r), r = pulsation / rate.
        const double r = m_waves[w].pulsation / rate, still = 1.0 - r * r, lag = 2.0 * ratio * r;
        const double gain = 1.0 / (still * still + lag * lag);
        const auto [sine, cosine] = maths::sincos(m_waves[w].pulsation * t);
        moment.sine[w] = m_waves[w].amplitude * (gain * (still * cosine + lag * sine));
        moment.cosine[w] = m_waves[w].amplitude * (gain * (lag * cosine - still * sine));
    }
    return moment;
}

glm::dvec3 WindField::velocity(const Moment& moment, Index slot) const
{
    glm::dvec3 sum = moment.mean;
    if (m_slots == 0)
        return sum;
    for (int w = 0; w < waves; ++w)
        sum += moment.sine[std::size_t(w)] * sinOf(w)[slot] + moment.cosine[std::size_t(w)] * cosOf(w)[slot];
    return sum;
}

} // namespace ramure
