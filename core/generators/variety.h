/// \file
/// Whether chance has a say in how a tree grows.
#pragma once

#include "core/params/node_params.h"

namespace ramure {

/// True where two seeds of a tree grown by chance can give two trees: a share of the variation is above 0, or
/// a rule chooses among several outcomes; of Weber and Penn, where a value varies or stems split. A grammar
/// that cannot be read gives no tree, hence no other one.
bool variesByChance(const NodeParams& params);

/// The tree of another seed, branches and leaves: grown by chance, also where it was not.
NodeParams reseeded(NodeParams params, std::int64_t seed);

} // namespace ramure
