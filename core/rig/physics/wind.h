/// \file
/// The wind: SPEC A7's for the faithful mode; for the robust one gusts and turbulence that travel through the
/// tree.
#pragma once

#include "core/params/physics_params.h"
#include "core/rig/physics/tree_body.h"
#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace ramure {

/// (u, 0, v) of SPEC A7 at time t, times windStrength, turned by windDirection about +Y.
glm::dvec3 faithfulWind(const PhysicsParams& params, double timeSeconds);

/// Mean velocity in m/s at strength 1 of the robust wind.
inline constexpr double robustWindSpeed = 4.0;

/// A sum of plane waves with phases from the seed: gusts along the wind and turbulence across it. The place
/// of a branch enters once; after that a step costs two products per wave.
class WindField
{
public:
    static constexpr int gustWaves = 2;
    static constexpr int turbulenceWaves = 4;
    static constexpr int waves = gustWaves + turbulenceWaves;

    WindField() = default;
    WindField(const TreeBody& body, const PhysicsParams& params) { setParams(body, params); }
    /// Sets the wind at the middle of every branch of the body at rest. The call costs almost nothing if seed
    /// and direction stay the same; then \p body must be the same, too.
    void setParams(const TreeBody& body, const PhysicsParams& params);

    /// The data of one moment: velocity at a slot = mean + sum over w of vector[w] * (sine[w] *
    /// cosOf(w)[slot] + ...).
    struct Moment
    {
        glm::dvec3 mean{0.0};
        std::array<glm::dvec3, waves> sine{}, cosine{}; ///< factors of sinOf(w)[slot] and cosOf(w)[slot]
    };
    [[nodiscard]] Moment at(double timeSeconds) const;
    /// The wind as a damped spring follows it which it has driven for long: gusts slower than the spring as
    /// they are, those near its own rate larger and later, faster ones hardly.
    /// \param rate rad/s, undamped. \param ratio of the damping to the critical one, > 0.
    [[nodiscard]] Moment felt(double timeSeconds, double rate, double ratio) const;
    /// m/s, tree space. The steps read the arrays themselves. Everywhere the mean without setParams().
    [[nodiscard]] glm::dvec3 velocity(const Moment& moment, Index slot) const;
    [[nodiscard]] const double* sinOf(int wave) const { return m_sin.data() + std::size_t(wave) * m_slots; }
    [[nodiscard]] const double* cosOf(int wave) const { return m_cos.data() + std::size_t(wave) * m_slots; }

private:
    void setPhases(const TreeBody& body);

    struct Wave
    {
        glm::dvec3 amplitude{0.0};  ///< m/s
        glm::dvec3 direction{0.0};  ///< direction of the eddy's velocity, unit length
        glm::dvec3 waveVector{0.0}; ///< rad/m
        double pulsation = 0.0;     ///< rad/s
        double phase = 0.0;
    };
    bool m_hasPhases = false;
    std::int64_t m_seed = 0;
    double m_directionRad = 0.0;
    glm::dvec3 m_mean{0.0};
    std::array<Wave, waves> m_waves{};
    std::size_t m_slots = 0;
    std::vector<double> m_sin, m_cos; ///< of the phase at each slot at time 0, wave by wave
};

} // namespace ramure
