/// \file
/// The course of one stem through the air, piece by piece: its curve, what is crooked by chance, the pull of
/// the sky and the way back after a split. Internal to the generator of Weber and Penn.
#pragma once

#include "core/math/frame.h"
#include "core/params/weber_penn_params.h"
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ramure {

/// A stem that is still to grow, or what a split adds to one: that goes on from \p begin.
struct Stem
{
    std::size_t level = 0;
    std::uint64_t address = 0; ///< of the whole stem
    std::uint64_t own = 0;     ///< of this stem of a split; the same where there is none
    glm::dvec3 foot{0.0};
    Frame frame;          ///< at the foot, the tangent its direction; carried without twist
    double azimuth = 0.0; ///< rad in the frame, of the direction away from what carries it
    double length = 0.0;  ///< m, of the whole stem
    double radius = 0.0;  ///< m, at the whole stem's foot
    double thin = 1.0;    ///< what splits left of the radius
    double carrier = 0.0; ///< m, radius of what carries it, there
    double parentLength = 0.0, offset = 0.0; ///< m, of what carries it, and where
    double begin = 0.0;                      ///< m along the whole stem
    int segment = 0;                         ///< the piece of the curve that begins there
    int share = 0, of = 1; ///< carries each stem whose number, modulo the second, is the first
    double splitAngle = 0.0, splitAzimuth = 0.0; ///< rad: turned there, to be turned back
};

class StemCourse
{
public:
    StemCourse(const WeberPennParams& params, std::uint64_t seed, const Stem& stem, double length);

    /// Goes on straight by \p step metres, after the turn that the way so far asks for.
    void advance(double step);
    [[nodiscard]] const glm::dvec3& position() const { return m_position; }
    [[nodiscard]] const Frame& frame() const { return m_frame; }
    /// Turns the rest of the way by \p angle towards \p azimuth of the frame, and back along it.
    void split(double angle, double azimuth);

private:
    /// Rad towards normal and binormal.
    void turn(const glm::dvec2& by);
    /// By the way so far, and so that \p next metres stay above the floor.
    void bend(double next);
    void attract(double step);
    void level(double next);

    const WeberPennLevel& m_level;
    double m_attraction;
    double m_floor; ///< m, of limbs; below all there is for others
    std::uint64_t m_seed, m_address;
    double m_length;
    glm::dvec2 m_away; ///< from what carries it: normal and binormal
    glm::dvec3 m_position;
    Frame m_frame;
    glm::dvec3 m_tangent; ///< where the frame turns to next: carried in one step, as skeletons do
    glm::dvec3 m_helix;
    double m_at;            ///< m along the whole stem
    double m_before = 0.0;  ///< the step before
    glm::dvec2 m_back{0.0}; ///< rad a metre, of the last split
    int m_segment = -1;
    double m_crooked = 0.0, m_aside = 0.0; ///< rad a metre, by chance, of the segment
};

} // namespace ramure
