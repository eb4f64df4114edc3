/// \file
/// The data of each plant's leaves: one row per shape.
#pragma once

#include "core/params/leaf_params.h"
#include <glm/vec3.hpp>

namespace ramure {

enum class LeafFamily : std::uint8_t {
    Blade,   ///< one blade on a midrib: elliptic to linear, heart-shaped, toothed, with lobes left and right
    Star,    ///< one blade whose lobes leave its foot: maple, ginkgo, fan palm
    Pinnate, ///< leaflets left and right of a rachis: ash, fern, palm; bipinnate where they have deep lobes
    Fingers, ///< leaflets from one place, side by side: horse chestnut, laburnum
    Tuft,    ///< needles from one place, all around
    Shoot,   ///< a twig of needles: each item on a branch is a shoot of the year
};

/// Lengths in shares of the whole leaf's where nothing else is said. "Blade" is a leaflet where there are
/// some.
struct LeafRow
{
    LeafShape shape;
    LeafFamily family = LeafFamily::Blade;
    double length = 0.45;    ///< leaf without its petiole, in steps of the tree
    double internode = 0.16; ///< in steps of the tree
    LeafArrangement arrangement = LeafArrangement::Alternate;
    double petiole = 0.25;
    double width = 0.5; ///< width of a blade, as a share of its own length
    /// The half width at the share u of a blade goes with u^base (1 - u)^tip: small numbers are blunt.
    double base = 0.5, tip = 0.8;
    double notch = 0.0;  ///< how far a blade reaches back beside its petiole
    double teeth = 0.0;  ///< depth as a share of half the width
    int lobes = 0;       ///< lobes on each side of a blade; all lobes of a star
    double depth = 0.0;  ///< depth of the bays between lobes, 0..1
    bool pointed = true; ///< the lobes
    /// rad: from the first lobe or finger to the last; between leaflet and rachis; of a tuft or shoot from
    /// its axis.
    double spread = 1.0;
    int leaflets = 0;     ///< pairs; of fingers, tufts and shoots in all
    double leaflet = 0.3; ///< length of the longest
    double dwindle = 0.3; ///< by how much the last leaflets, or the outermost lobes and fingers, are shorter
    int rosettes = 0;  ///< number of rosettes on a shoot that hold its needles; 0: needles stand one by one
    bool flat = false; ///< the needles of a shoot part left and right
    double bareFoot = 0.05;               ///< share of a shoot before its first needle
    glm::u8vec3 colour{0x72, 0x99, 0x3C}; ///< sRGB, of the brightest leaf
    glm::u8vec3 autumn{0xD8, 0xAE, 0x32}; ///< autumn colour
    bool evergreen = false;
};

/// \pre not Faithful.
const LeafRow& leafRow(LeafShape shape);

/// Returns the colour that the tones of a plant's leaves refer to: that of the brightest leaf or, if they \p
/// turn, a colour that is nowhere darker than any of the year. \pre not Faithful.
glm::u8vec3 leafColour(LeafShape shape, bool turn);

} // namespace ramure
