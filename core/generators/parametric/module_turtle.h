/// \file
/// The turtle of the parametric dialect: modules with numbers become a skeleton.
///
/// Heading H = +Y, left L = -X, up U = +Z at the start. F(l) draws a branch of length l, f(l) moves, !(w)
/// sets the diameter. + - turn about U, & ^ about L, \ / about H by degrees: right-handed for + & \, the
/// other way for - ^ /. | is half a turn about U, $ rolls so that L is level, [ ] branch, % leaves out the
/// rest of the branch; ~(name, size) puts an organ here that points ahead; all other modules draw nothing.
/// Without a number a turn is turtle.theta, a length turtle.alpha, and ! narrows by turtle.decay.
#pragma once

#include "core/base/progress.h"
#include "core/generators/grammar/turtle.h"
#include "core/generators/parametric/derive.h"

namespace ramure {

/// A piece that continues an axis narrows from the width before to its own; the others keep theirs. After
/// each F the turtle turns about H x T by e |H x T| rad, T = turtle.tropism, e = turtle.elasticity ("The
/// Algorithmic Beauty of Plants", 2.3). Levels and keys as those of runTurtle; what is drawn after f is a new
/// root, its key that of a branch in that place. With \p chance turns and lengths vary as there, radii do
/// not. Errors: Invalid with the place of the module (a length, a diameter or an organ's size below 0, an
/// organ before any branch, a tree beyond 10^6 km), Invalid with path (no branch at all), Limit, Cancelled.
Expected<Skeleton> runModuleTurtle(const ModuleWord& word, const TurtleParams& params,
                                   const TurtleChance& chance, const Progress& progress = {});

} // namespace ramure
