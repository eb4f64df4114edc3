/// \file
/// Levels of detail: how many meshes of one tree, and how many triangles each may have.
#pragma once

#include "core/base/error.h"
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ramure {

inline constexpr std::int64_t mostLevels = 8, leastBudget = 50, mostBudget = 20'000'000;
/// How far a level is from its budget at most, as a share of it.
inline constexpr double levelSlack = 0.02;
/// A level without a budget has this share of the triangles of the level before it.
inline constexpr double levelStep = 0.25;
/// And of the bark's alone, at most.
inline constexpr double levelBarkStep = 0.5;
/// Default for the second level: it takes over if the tree has this share of the picture's height, as in the
/// groups of levels of game engines. Each further level takes over at usualShareStep times the share of the
/// level before.
inline constexpr double usualShare = 0.6, usualShareStep = 0.5;
/// A level takes over at this share of the picture's height at most, because nearer viewers no longer see the
/// tree as a whole.
inline constexpr double mostShare = 10.0;
/// rad: the vertical angle of view for which distances are told, that of the view.
inline constexpr double levelFovRad = 0.69;

struct LevelOptions
{
    std::int64_t count = 0; ///< of meshes; 0: no levels, the tree alone
    /// Triangles of bark, leaves and fruit together, the finest first, each less than the one before; empty:
    /// the first level is the tree as it is, each further one has a quarter of the triangles, or less
    /// where that would give it more than half of the bark's.
    std::vector<std::int64_t> budgets{};
    /// When each level but the first takes the place of the one before; at most one of the two is not empty,
    /// and with neither it is the usual shares. Metres in the scene, from the eye to the tree, rising; or
    /// shares of the picture's height that the tree has, falling.
    std::vector<double> distances{}, shares{};
    bool cards = false; ///< leaves of plants are cards with pictures of twigs, where they are not all there
    bool billboard = false; ///< after them one level more: crossed cards with pictures of the whole tree
    bool operator==(const LevelOptions&) const = default;

    [[nodiscard]] bool isWanted() const { return count > 0; }
    /// With the billboard.
    [[nodiscard]] std::int64_t total() const { return isWanted() ? count + (billboard ? 1 : 0) : 0; }
    /// The finest level is the tree itself, whose meshes are needed then.
    [[nodiscard]] bool beginsWhole() const { return budgets.empty(); }
    /// Their meshes are the same, whenever they are shown.
    [[nodiscard]] bool makesLike(const LevelOptions& other) const
    {
        return count == other.count && budgets == other.budgets && cards == other.cards &&
               billboard == other.billboard;
    }
};

/// Returns the usual levels of one tree in a game: 80,000, 20,000, 5,000 and 1,250 triangles, with cards,
/// and the billboard.
LevelOptions gameLevels();

/// Errors: Invalid (a count out of range, as many budgets as levels, a budget below leastBudget or over
/// mostBudget, budgets that do not fall; distances that do not rise from more than 0, shares that do not fall
/// or are over mostShare, not one of them for each level but the first).
Expected<void> checkLevels(const LevelOptions& options);

/// Reads "20, 60" or "20 m, 60 m" as distances, "60%, 30%" as shares, and an empty text as the usual ones. If
/// semicolons part the numbers, a comma in one is a decimal point. Error: Invalid (no number, or both kinds
/// in one text); the options stay as they were.
Expected<void> readSwitches(std::string_view text, LevelOptions& options);
/// Writes the switches as a text for readSwitches(): "20; 60.5", "60 %; 30 %".
std::string switchesText(const LevelOptions& options);

} // namespace ramure
