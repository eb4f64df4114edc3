/// \file
/// A USD layer as it stands in its text (.usda): prims with their attributes, relationships and variants. It
/// is strict: what the language does not allow is an error with its line. Internal to the formats.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ramure::usd {

/// Numbers, or texts: strings, tokens, assets, paths. Empty: None.
struct Value
{
    std::vector<double> numbers; ///< of all elements, one after the other
    std::vector<std::string> texts;
    std::map<std::string, Value> members; ///< of a dictionary
    bool isArray = false;
};

struct Attribute
{
    std::string type;   ///< "point3f", without brackets
    int components = 0; ///< numbers of an element; 0: it has texts
    bool isArray = false;
    bool isUniform = false;
    std::shared_ptr<const Value> value; ///< null: it has none
    std::map<double, std::shared_ptr<const Value>> samples;
    std::vector<std::string> connections;
    std::map<std::string, Value> metadata;
    int line = 0;

    /// The value, of one that moves its first; null: there is none.
    [[nodiscard]] const Value* get() const;
};

enum class Specifier : std::uint8_t { Def, Over, Class };

struct Prim
{
    struct VariantSet
    {
        std::string name;
        std::vector<std::pair<std::string, std::shared_ptr<const Prim>>> variants;
    };

    Specifier specifier = Specifier::Over;
    std::string type, name;
    int line = 0;
    std::map<std::string, Value> metadata; ///< of lists that are edited all that is added
    std::map<std::string, Attribute> attributes;
    std::map<std::string, std::vector<std::string>> relations;
    std::vector<std::shared_ptr<Prim>> children;
    std::vector<VariantSet> sets;

    [[nodiscard]] const Prim* child(std::string_view name) const;
    [[nodiscard]] const Attribute* attribute(const std::string& name) const;
    /// The first text of an attribute; empty: it has none.
    [[nodiscard]] std::string text(const std::string& name) const;
    /// The first text of a metadatum; empty: there is none.
    [[nodiscard]] std::string said(const std::string& name) const;
};

struct Layer
{
    Prim root; ///< without a name; its metadata are those of the layer
};

/// The numbers that an element of a type has; 0: it has texts; -1: no such type. \param type without brackets
int componentsOf(std::string_view type);

/// \param file of which errors tell. Errors, with file, line and column: Syntax; Invalid (a value that is not
/// of its type, a number that is not finite, a name twice); Limit (prims deeper than 128, over a million of
/// them); Cancelled.
Expected<Layer> parseLayer(std::string_view text, const std::string& file, const Progress& progress = {});

/// Another layer by the name of its file, as it stands in metadata; null: it cannot be read.
using LayerSource = std::function<std::shared_ptr<const Layer>(const std::string& asset)>;
/// Makes the names of files in a layer, and its paths to its own prims, those of the layer that refers to it.
/// \param asset its own name, as that one has it
void relocate(Layer& layer, const std::string& asset);

/// The layer as it is seen: variants chosen, references resolved. \param notes get what is left out: other
/// files. Errors: Invalid (a reference to a prim of this file that there is not), Limit.
Expected<Layer> composed(const Layer& layer, std::vector<std::string>& notes, const LayerSource& others = {});

/// Finds the prim of a path such as "/Scene/Oak"; null: there is none.
const Prim* primAt(const Prim& root, std::string_view path);

} // namespace ramure::usd
