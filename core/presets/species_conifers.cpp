#include "core/presets/species.h"

#include <array>

namespace ramure {
namespace {

using S = CrownShape;
using L = LeafShape;
using B = BarkFamily;
using F = FruitKind;

/// Our own numbers in the paper's style, from how such trees stand.
// clang-format off
const std::array conifers{
    Species{"EuropeanLarch1995", "Larix decidua", RAMURE_NOOP("A slender open cone that is bare in winter"), true,
        {.shape = S::Envelope, .baseSize = 0.12, .scale = 14.4, .scaleV = 1.2, .levels = 3, .ratio = 0.0183, .ratioPower = 1.4, .lobes = 0, .flare = 0.5, .attractionUp = -0.4,
         .pruneWidthPeak = 0.05, .prunePowerLow = 0.05, .prunePowerHigh = 0.8,
         .level = {{{.curveRes = 8, .curveV = 10},
                    {.length = 0.378, .lengthV = 0.03, .curveRes = 6, .curve = 30, .curveBack = -55, .curveV = 30, .downAngle = 82, .downAngleV = -20, .rotate = 137, .rotateV = 15, .branches = 90},
                    {.length = 0.34, .lengthV = 0.08, .curveRes = 3, .curve = 60, .curveV = 30, .downAngle = 60, .downAngleV = 10, .rotate = -90, .rotateV = 25, .branches = 36},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Larch, 3.3, 1.4, 0.16, B::Scaly, 0.1, F::Cone, 0.006, 0.022}},
    Species{"DouglasFir1995", "Pseudotsuga menziesii", RAMURE_NOOP("A very tall dense spire on a furrowed trunk"), true,
        {.shape = S::Envelope, .baseSize = 0.1, .scale = 30, .scaleV = 3, .levels = 3, .ratio = 0.0151, .ratioPower = 1.5, .lobes = 0, .flare = 0.6, .attractionUp = 0.1,
         .pruneWidthPeak = 0.05, .prunePowerLow = 0.05, .prunePowerHigh = 0.85,
         .level = {{{.curveRes = 8, .curveV = 5},
                    {.length = 0.273, .lengthV = 0.02, .curveRes = 5, .curve = -10, .curveBack = -20, .curveV = 20, .downAngle = 88, .downAngleV = -35, .rotate = 137, .rotateV = 10, .branches = 150},
                    {.length = 0.36, .lengthV = 0.05, .curveRes = 2, .curve = 15, .curveV = 20, .downAngle = 55, .downAngleV = 8, .rotate = -95, .rotateV = 15, .branches = 38},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Spruce, 2.3, 1.35, 0.14, B::Furrowed, -0.05, F::Cone, 0.004, 0.035}},
    Species{"StonePine1995", "Pinus pinea", RAMURE_NOOP("An umbrella on a tall bare trunk"), true,
        {.shape = S::Hemispherical, .baseSize = 0.66, .scale = 16, .scaleV = 1.5, .levels = 3, .ratio = 0.022, .ratioPower = 1.3, .lobes = 0, .flare = 0.4, .attractionUp = 0.6,
         .level = {{{.curveRes = 8, .curveV = 25},
                    {.length = 0.42, .lengthV = 0.03, .segSplits = 0.15, .splitAngle = 25, .splitAngleV = 8, .curveRes = 6, .curve = -15, .curveV = 35, .downAngle = 64, .downAngleV = -30, .rotate = 137, .rotateV = 15, .branches = 40},
                    {.length = 0.34, .lengthV = 0.06, .curveRes = 4, .curve = -50, .curveV = 40, .downAngle = 45, .downAngleV = 12, .rotate = 137, .rotateV = 20, .branches = 46},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::ScotsPine, 1.65, 0.62, 0.12, B::Plated, 0.1, F::Cone, 0.008, 0.03}},
    Species{"LebanonCedar1995", "Cedrus libani", RAMURE_NOOP("Wide level tables of dark needles, one above the other"), true,
        {.shape = S::TaperedCylindrical, .baseSize = 0.1, .scale = 22, .scaleV = 2, .levels = 3, .ratio = 0.026, .ratioPower = 1.4, .lobes = 0, .flare = 0.8, .attractionUp = 0.1,
         .level = {{{.segSplits = 0.08, .splitAngle = 14, .curveRes = 8, .curveV = 25},
                    {.length = 0.5, .lengthV = 0.1, .segSplits = 0.12, .splitAngle = 25, .splitAngleV = 10, .curveRes = 6, .curve = -8, .curveBack = 20, .curveV = 25, .downAngle = 72, .downAngleV = -12, .rotate = 137, .rotateV = 40, .branches = 36},
                    {.length = 0.34, .lengthV = 0.06, .curveRes = 3, .curve = 0, .curveV = 25, .downAngle = 58, .downAngleV = 8, .rotate = -88, .rotateV = 8, .branches = 110},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Cedar, 2.1, 1.1, 0.14, B::Scaly, -0.05, F::Cone, 0.006, 0.055}},
    Species{"ItalianCypress1995", "Cupressus sempervirens", RAMURE_NOOP("A dark green flame, hardly wider than its trunk"), true,
        {.shape = S::TendFlame, .baseSize = 0.03, .scale = 16, .scaleV = 1.5, .levels = 3, .ratio = 0.012, .ratioPower = 1.2, .lobes = 0, .flare = 0.5, .attractionUp = 3,
         .level = {{{.curveRes = 8, .curveV = 5},
                    {.length = 0.13, .lengthV = 0.02, .curveRes = 4, .curve = -25, .curveV = 10, .downAngle = 35, .downAngleV = -12, .rotate = 137, .rotateV = 15, .branches = 130},
                    {.length = 0.4, .lengthV = 0.08, .curveRes = 2, .curve = -15, .curveV = 15, .downAngle = 30, .downAngleV = 8, .rotate = 137, .rotateV = 20, .branches = 20},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Cypress, 2.2, 1.0, 0.16, B::Fibrous, 0}},
    Species{"GiantSequoia1995", "Sequoiadendron giganteum", RAMURE_NOOP("A massive flared column with a narrow crown of short limbs"), true,
        {.shape = S::Hemispherical, .baseSize = 0.3, .scale = 55, .scaleV = 4, .levels = 3, .ratio = 0.034, .ratioPower = 1.9, .lobes = 7, .lobeDepth = 0.06, .flare = 1.4, .attractionUp = 0.6,
         .level = {{{.taper = 0.95, .curveRes = 8, .curveV = 4},
                    {.length = 0.145, .lengthV = 0.03, .curveRes = 6, .curve = 35, .curveBack = -80, .curveV = 40, .downAngle = 75, .downAngleV = -20, .rotate = 137, .rotateV = 25, .branches = 96},
                    {.length = 0.34, .lengthV = 0.06, .curveRes = 3, .curve = -20, .curveV = 40, .downAngle = 50, .downAngleV = 12, .rotate = 137, .rotateV = 25, .branches = 52},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Cypress, 1.0, 0.6, 0.05, B::Fibrous, 0.1}},
    Species{"CommonYew1995", "Taxus baccata", RAMURE_NOOP("A broad dark dome, several stems from one foot"), true,
        {.shape = S::Hemispherical, .baseSize = 0.05, .scale = 14.1, .scaleV = 1.3, .levels = 3, .ratio = 0.0334, .ratioPower = 1.5, .lobes = 7, .lobeDepth = 0.12, .flare = 0.8, .attractionUp = 0.6,
         .level = {{{.length = 0.9, .baseSplits = 3, .segSplits = 0.1, .splitAngle = 28, .curveRes = 6, .curveV = 40},
                    {.length = 0.397, .lengthV = 0.08, .segSplits = 0.1, .splitAngle = 25, .curveRes = 6, .curve = -10, .curveV = 50, .downAngle = 52, .downAngleV = -25, .rotate = 137, .rotateV = 20, .branches = 80},
                    {.length = 0.36, .lengthV = 0.06, .curveRes = 3, .curve = 20, .curveV = 40, .downAngle = 50, .downAngleV = 10, .rotate = -95, .rotateV = 20, .branches = 80},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Yew, 3.2, 1.1, 0.36, B::Peeling, -0.1}},
    Species{"EasternWhitePine1995", "Pinus strobus", RAMURE_NOOP("Level whorled limbs with soft plumes of needles"), true,
        {.shape = S::Conical, .baseSize = 0.14, .scale = 19.7, .scaleV = 2, .levels = 3, .ratio = 0.0165, .ratioPower = 1.35, .lobes = 0, .flare = 0.5, .attractionUp = 0.6,
         .level = {{{.curveRes = 8, .curveV = 10},
                    {.length = 0.311, .lengthV = 0.06, .curveRes = 6, .curve = -20, .curveV = 30, .downAngle = 82, .downAngleV = -25, .rotate = 72, .rotateV = 15, .branches = 60},
                    {.length = 0.36, .lengthV = 0.06, .curveRes = 3, .curve = -30, .curveV = 30, .downAngle = 50, .downAngleV = 10, .rotate = -95, .rotateV = 15, .branches = 38},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::WhitePine, 1.0, 0.8, 0.13, B::Furrowed, 0, F::Cone, 0.006, 0.035}},
    Species{"BalsamFir1995", "Abies balsamea", RAMURE_NOOP("A narrow regular spire, dense to the ground"), true,
        {.shape = S::Envelope, .baseSize = 0.03, .scale = 16, .scaleV = 1.5, .levels = 3, .ratio = 0.015, .ratioPower = 1.4, .lobes = 0, .flare = 0.4, .attractionUp = 0.2,
         .pruneWidthPeak = 0.05, .prunePowerLow = 0.05, .prunePowerHigh = 0.9,
         .level = {{{.curveRes = 8, .curveV = 4},
                    {.length = 0.22, .lengthV = 0.02, .curveRes = 4, .curve = -12, .curveV = 15, .downAngle = 84, .downAngleV = -28, .rotate = 137, .rotateV = 8, .branches = 140},
                    {.length = 0.38, .lengthV = 0.05, .curveRes = 2, .curve = -10, .curveV = 15, .downAngle = 52, .downAngleV = 8, .rotate = -92, .rotateV = 8, .branches = 34},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Fir, 3.4, 1.5, 0.18, B::Smooth, 0.1, F::Cone, 0.004, 0.04}},
    Species{"BlueSpruce1995", "Picea pungens", RAMURE_NOOP("A stiff broad cone of level limbs"), true,
        {.shape = S::Envelope, .baseSize = 0.04, .scale = 16.7, .scaleV = 1.5, .levels = 3, .ratio = 0.0191, .ratioPower = 1.4, .lobes = 0, .flare = 0.4, .attractionUp = 0.4,
         .pruneWidthPeak = 0.05, .prunePowerLow = 0.05, .prunePowerHigh = 0.9,
         .level = {{{.curveRes = 8, .curveV = 4},
                    {.length = 0.278, .lengthV = 0.02, .curveRes = 5, .curve = -10, .curveBack = -10, .curveV = 15, .downAngle = 86, .downAngleV = -26, .rotate = 137, .rotateV = 10, .branches = 100},
                    {.length = 0.36, .lengthV = 0.05, .curveRes = 2, .curve = -10, .curveV = 15, .downAngle = 52, .downAngleV = 8, .rotate = -92, .rotateV = 10, .branches = 38},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::BlueSpruce, 2.8, 1.2, 0.18, B::Scaly, 0.1, F::Cone, 0.005, 0.03}},
    Species{"CoastRedwood1995", "Sequoia sempervirens", RAMURE_NOOP("A tower with a narrow crown of sinking limbs"), true,
        {.shape = S::Envelope, .baseSize = 0.12, .scale = 32.4, .scaleV = 2.9, .levels = 3, .ratio = 0.0158, .ratioPower = 1.6, .lobes = 5, .lobeDepth = 0.06, .flare = 1, .attractionUp = 0.1,
         .pruneWidthPeak = 0.05, .prunePowerLow = 0.05, .prunePowerHigh = 0.75,
         .level = {{{.curveRes = 8, .curveV = 5},
                    {.length = 0.197, .lengthV = 0.03, .curveRes = 6, .curve = 20, .curveBack = -45, .curveV = 25, .downAngle = 84, .downAngleV = -25, .rotate = 137, .rotateV = 15, .branches = 110},
                    {.length = 0.36, .lengthV = 0.06, .curveRes = 3, .curve = 20, .curveV = 25, .downAngle = 54, .downAngleV = 10, .rotate = -92, .rotateV = 12, .branches = 38},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Yew, 2.1, 0.8, 0.1, B::Fibrous, 0.15}},
    Species{"DeodarCedar1995", "Cedrus deodara", RAMURE_NOOP("A wide cone whose limbs and top hang over"), true,
        {.shape = S::Conical, .baseSize = 0.06, .scale = 23.3, .scaleV = 1.9, .levels = 3, .ratio = 0.0217, .ratioPower = 1.4, .lobes = 0, .flare = 0.7, .attractionUp = -0.4,
         .level = {{{.curveRes = 8, .curveV = 12},
                    {.length = 0.421, .lengthV = 0.04, .curveRes = 6, .curve = -10, .curveBack = 35, .curveV = 20, .downAngle = 80, .downAngleV = -22, .rotate = 137, .rotateV = 15, .branches = 80},
                    {.length = 0.34, .lengthV = 0.06, .curveRes = 3, .curve = 40, .curveV = 25, .downAngle = 56, .downAngleV = 8, .rotate = -90, .rotateV = 12, .branches = 60},
                    {.length = 0.3, .curveRes = 1}}}},
        {L::Cedar, 2.4, 0.95, 0.13, B::Furrowed, -0.15}},
};
// clang-format on

} // namespace

std::span<const Species> coniferSpecies()
{
    return conifers;
}

} // namespace ramure
