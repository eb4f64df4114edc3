#include "core/io/formats/usd/usd_layer.h"

#include "core/io/formats/usd/usd_scanner.h"
#include <algorithm>
#include <filesystem>
#include <set>

namespace ramure::usd {
namespace {

constexpr int deepest = 128;
constexpr std::size_t mostPrims = 1'000'000;
constexpr int deepestSubLayer = 8;

/// Reads prims and what is in them. Each function leaves a problem in the scanner and returns false.
class LayerReader
{
public:
    LayerReader(Scanner& scanner, const Progress& progress)
        : m_in(scanner)
        , m_progress(progress)
    {
    }

    bool read(Layer& out)
    {
        if (!m_in.takeHeader())
            return false;
        if (m_in.takes('(') && !readMetadata(out.root.metadata))
            return false;
        while (!m_in.atEnd()) {
            std::string word;
            if (!m_in.word(word) || !readPrim(out.root, word, 1))
                return false;
        }
        return true;
    }

private:
    using Metadata = std::map<std::string, Value>;

    static bool isListWord(std::string_view word)
    {
        return word == "prepend" || word == "append" || word == "add" || word == "delete" ||
               word == "reorder";
    }

    /// Behind the opening bracket, up to the closing one.
    bool readMetadata(Metadata& out)
    {
        while (!m_in.takes(')')) {
            if (m_in.takes(';') || m_in.takes(','))
                continue;
            if (m_in.peek() == '"' || m_in.peek() == '\'') {
                std::string comment;
                if (!m_in.string(comment))
                    return false;
                continue;
            }
            std::string word, edit;
            if (!m_in.word(word))
                return false;
            if (isListWord(word)) {
                edit = word;
                if (!m_in.word(word))
                    return false;
            }
            Value value;
            if (!m_in.expect('=') || !m_in.value(value))
                return false;
            if (edit != "delete" && edit != "reorder" && !keep(out, word, std::move(value)))
                return false;
        }
        return true;
    }

    /// Lists that are prepended and appended become one.
    bool keep(Metadata& out, const std::string& name, Value value)
    {
        const auto [place, isNew] = out.try_emplace(name, Value());
        if (isNew)
            place->second = std::move(value);
        else
            for (std::string& text : value.texts)
                place->second.texts.push_back(std::move(text));
        return true;
    }

    /// \param word def, over or class, which was read
    bool readPrim(Prim& parent, const std::string& word, int depth)
    {
        auto prim = std::make_shared<Prim>();
        prim->line = m_in.line();
        if (word != "def" && word != "over" && word != "class")
            return m_in.refuse(ErrorCode::Syntax, RAMURE_NOOP("\"%1\" where a prim begins"), {word});
        prim->specifier = word == "def"    ? Specifier::Def
                          : word == "over" ? Specifier::Over
                                           : Specifier::Class;
        if (m_in.peek() != '"' && m_in.peek() != '\'' && !m_in.word(prim->type))
            return false;
        if (!m_in.string(prim->name))
            return false;
        if (!isName(prim->name))
            return m_in.refuse(ErrorCode::Invalid, RAMURE_NOOP("\"%1\" is no name of a prim"), {prim->name});
        if (parent.child(prim->name))
            return m_in.refuse(ErrorCode::Invalid, RAMURE_NOOP("two prims have the name \"%1\""),
                               {prim->name});
        if (depth > deepest || ++m_count > mostPrims)
            return m_in.refuse(ErrorCode::Limit, RAMURE_NOOP("more prims than a file can have"));
        if (m_progress.cancelled())
            return m_in.refuse(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        m_progress.report(m_in.fraction());
        if (m_in.takes('(') && !readMetadata(prim->metadata))
            return false;
        parent.children.push_back(prim);
        return m_in.expect('{') && readContent(*prim, depth);
    }

    /// Letters, digits and underscores; characters beyond ASCII are allowed.
    static bool isName(const std::string& name)
    {
        const auto isPart = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                   static_cast<unsigned char>(c) >= 0x80;
        };
        return !name.empty() && !(name[0] >= '0' && name[0] <= '9') && std::ranges::all_of(name, isPart);
    }

    /// Behind the opening brace, up to the closing one.
    bool readContent(Prim& prim, int depth)
    {
        while (!m_in.takes('}')) {
            if (m_in.takes(';'))
                continue;
            std::string word;
            if (!m_in.word(word))
                return false;
            const bool isPrim = word == "def" || word == "over" || word == "class";
            const bool fine = isPrim                 ? readPrim(prim, word, depth + 1)
                              : word == "variantSet" ? readVariants(prim, depth)
                                                     : readProperty(prim, std::move(word));
            if (!fine)
                return false;
        }
        return true;
    }

    bool readVariants(Prim& prim, int depth)
    {
        Prim::VariantSet set;
        if (!m_in.string(set.name) || !m_in.expect('=') || !m_in.expect('{'))
            return false;
        if (depth > deepest)
            return m_in.refuse(ErrorCode::Limit, RAMURE_NOOP("more prims than a file can have"));
        while (!m_in.takes('}')) {
            std::string name;
            auto body = std::make_shared<Prim>();
            if (!m_in.string(name) || (m_in.takes('(') && !readMetadata(body->metadata)) ||
                !m_in.expect('{') || !readContent(*body, depth + 1))
                return false;
            set.variants.emplace_back(std::move(name), std::move(body));
        }
        prim.sets.push_back(std::move(set));
        return true;
    }

    /// \param word the first one, which was read
    bool readProperty(Prim& prim, std::string word)
    {
        std::string edit;
        Attribute attribute;
        while (word == "custom" || word == "uniform" || word == "varying" || word == "config" ||
               isListWord(word)) {
            attribute.isUniform = attribute.isUniform || word == "uniform";
            edit = isListWord(word) ? word : edit;
            if (!m_in.word(word))
                return false;
        }
        if (edit == "reorder") { // of children or properties
            Value order;
            return m_in.expect('=') && m_in.value(order);
        }
        attribute.line = m_in.line();
        if (word == "rel")
            return readRelation(prim, edit);
        attribute.components = componentsOf(word);
        if (attribute.components < 0)
            return m_in.refuse(ErrorCode::Syntax, RAMURE_NOOP("\"%1\" is no type of an attribute"), {word});
        attribute.type = word;
        if (m_in.takes('[')) {
            attribute.isArray = true;
            if (!m_in.expect(']'))
                return false;
        }
        std::string name;
        return m_in.name(name) && readAttribute(prim, std::move(name), std::move(attribute), edit);
    }

    bool readAttribute(Prim& prim, std::string name, Attribute attribute, const std::string& edit)
    {
        std::string kind;
        if (const std::size_t dot = name.find('.'); dot != std::string::npos) {
            kind = name.substr(dot + 1);
            name.resize(dot);
        }
        const auto [place, isNew] = prim.attributes.try_emplace(name, attribute);
        Attribute& into = place->second;
        if (into.type != attribute.type || into.isArray != attribute.isArray)
            return m_in.refuse(ErrorCode::Invalid, RAMURE_NOOP("the attribute \"%1\" has two types"), {name});
        if (kind == "connect") {
            Value paths;
            if (!m_in.expect('=') || !m_in.value(paths))
                return false;
            if (edit != "delete")
                into.connections = std::move(paths.texts);
        } else if (kind == "timeSamples") {
            if (!m_in.expect('=') || !m_in.expect('{') || !readSamples(into))
                return false;
        } else if (!kind.empty()) {
            return m_in.refuse(ErrorCode::Syntax, RAMURE_NOOP("\"%1\" is no part of an attribute"), {kind});
        } else if (m_in.takes('=')) {
            if (!isNew && into.value)
                return m_in.refuse(ErrorCode::Invalid, RAMURE_NOOP("the attribute \"%1\" stands there twice"),
                                   {name});
            auto value = std::make_shared<Value>();
            if (!m_in.typedValue(*value, into.components, into.isArray))
                return false;
            into.value = std::move(value);
        }
        return !m_in.takes('(') || readMetadata(into.metadata);
    }

    bool readSamples(Attribute& into)
    {
        while (!m_in.takes('}')) {
            double code = 0.0;
            auto value = std::make_shared<Value>();
            if (!m_in.number(code) || !m_in.expect(':') ||
                !m_in.typedValue(*value, into.components, into.isArray))
                return false;
            into.samples[code] = std::move(value);
            if (!m_in.takes(',') && m_in.peek() != '}')
                return m_in.expect(',');
        }
        return true;
    }

    bool readRelation(Prim& prim, const std::string& edit)
    {
        std::string name;
        if (!m_in.name(name))
            return false;
        std::vector<std::string>& targets = prim.relations[name];
        if (m_in.takes('=')) {
            Value paths;
            if (!m_in.value(paths))
                return false;
            if (!paths.numbers.empty())
                return m_in.refuse(ErrorCode::Invalid, RAMURE_NOOP("a relationship leads to paths"));
            if (edit != "delete")
                targets = std::move(paths.texts);
        }
        Metadata ignored;
        return !m_in.takes('(') || readMetadata(ignored);
    }

    Scanner& m_in;
    const Progress& m_progress;
    std::size_t m_count = 0;
};

/// What the weaker prim says and the stronger one does not.
void merge(Prim& strong, const Prim& weak)
{
    if (strong.specifier == Specifier::Over)
        strong.specifier = weak.specifier;
    if (strong.type.empty())
        strong.type = weak.type;
    for (const auto& [name, value] : weak.metadata) {
        const auto [place, isNew] = strong.metadata.try_emplace(name, value);
        if (!isNew)
            for (const auto& [key, member] : value.members)
                place->second.members.try_emplace(key, member);
    }
    for (const auto& [name, attribute] : weak.attributes) {
        const auto [place, isNew] = strong.attributes.try_emplace(name, attribute);
        Attribute& own = place->second;
        if (!isNew && !own.value && own.samples.empty()) {
            own.value = attribute.value;
            own.samples = attribute.samples;
        }
        if (own.connections.empty())
            own.connections = attribute.connections;
    }
    for (const auto& [name, targets] : weak.relations)
        strong.relations.try_emplace(name, targets);
    for (const auto& child : weak.children) {
        const auto same = std::ranges::find(
            strong.children, child->name, [](const auto& other) -> const auto& { return other->name; });
        if (same == strong.children.end()) {
            strong.children.push_back(std::make_shared<Prim>(*child));
        } else {
            *same = std::make_shared<Prim>(**same); // others may share it
            merge(**same, *child);
        }
    }
    for (const Prim::VariantSet& set : weak.sets)
        if (std::ranges::find(strong.sets, set.name, &Prim::VariantSet::name) == strong.sets.end())
            strong.sets.push_back(set);
}

/// What leads to one prim or below it leads to another one.
void redirect(Prim& prim, const std::string& from, const std::string& to)
{
    const auto change = [&](std::vector<std::string>& paths) {
        for (std::string& path : paths)
            if (path.starts_with(from) &&
                (path.size() == from.size() || path[from.size()] == '/' || path[from.size()] == '.'))
                path.replace(0, from.size(), to);
    };
    for (auto& [name, targets] : prim.relations)
        change(targets);
    for (auto& [name, attribute] : prim.attributes)
        change(attribute.connections);
    for (auto& child : prim.children) {
        child = std::make_shared<Prim>(*child); // others may share it
        redirect(*child, from, to);
    }
    for (Prim::VariantSet& set : prim.sets)
        for (auto& [name, variant] : set.variants) {
            auto own = std::make_shared<Prim>(*variant);
            redirect(*own, from, to);
            variant = std::move(own);
        }
}

class Composer
{
public:
    Composer(const Layer& layer, std::vector<std::string>& notes, const LayerSource& others)
        : m_layer(layer)
        , m_notes(notes)
        , m_others(others)
    {
    }

    Expected<void> compose(Prim& prim, const std::string& path, int depth)
    {
        if (depth > deepest || ++m_count > mostPrims)
            return fail(ErrorCode::Limit, RAMURE_NOOP("more prims than a file can have"));
        std::set<std::string> chosen;
        choose(prim, chosen);
        std::set<std::string> seen;
        for (const char* arc : {"inherits", "references", "payload", "specializes"})
            RAMURE_TRY(follow(prim, path, arc, seen));
        choose(prim, chosen);
        for (auto& child : prim.children) {
            child = std::make_shared<Prim>(*child);
            RAMURE_TRY(compose(*child, path + "/" + child->name, depth + 1));
        }
        return {};
    }

private:
    /// Variants of sets that were not chosen yet. One may bring further sets.
    static void choose(Prim& prim, std::set<std::string>& chosen)
    {
        for (std::size_t i = 0; i < prim.sets.size(); ++i) {
            const Prim::VariantSet set = prim.sets[i];
            if (set.variants.empty() || !chosen.insert(set.name).second)
                continue;
            const auto choices = prim.metadata.find("variants");
            const Value* choice = nullptr;
            if (choices != prim.metadata.end())
                if (const auto own = choices->second.members.find(set.name);
                    own != choices->second.members.end())
                    choice = &own->second;
            const std::string name = choice && !choice->texts.empty() ? choice->texts.front() : "";
            const auto found = std::ranges::find(set.variants, name, [](const auto& v) { return v.first; });
            merge(prim, *(found == set.variants.end() ? set.variants.front() : *found).second);
        }
    }

    /// The prim that a reference leads to, here or in another file, with its path there; null: there is none.
    std::pair<const Prim*, std::string> primOf(const std::string& text)
    {
        if (text.starts_with('/'))
            return {primAt(m_layer.root, text), text};
        const std::size_t end = std::min(text.find('<'), text.size());
        const auto other = m_others ? m_others(text.substr(0, end)) : nullptr;
        if (!other)
            return {};
        const std::string path =
            end < text.size() ? text.substr(end + 1) : "/" + other->root.said("defaultPrim");
        return {path.size() > 1 ? primAt(other->root, path) : nullptr, path};
    }

    Expected<void> follow(Prim& prim, const std::string& own, const char* arc, std::set<std::string>& seen)
    {
        const auto found = prim.metadata.find(arc);
        if (found == prim.metadata.end())
            return {};
        const std::vector<std::string> paths = found->second.texts;
        for (const std::string& text : paths) {
            if (!seen.insert(text).second)
                continue;
            const auto [from, path] = primOf(text);
            const bool isClass = *arc == 'i' || *arc == 's'; // of classes nobody says that they are there
            if (!from && !text.starts_with('/'))
                m_notes.push_back(text.substr(0, text.find('<')));
            if (!from && (isClass || !text.starts_with('/')))
                continue;
            if (!from) {
                auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("there is no prim %1"), {text});
                error.value().line = prim.line;
                return error;
            }
            Prim base = *from;
            base.specifier = Specifier::Def; // what a class describes is there now
            base.metadata.erase("instanceable");
            redirect(base, path, own);
            merge(prim, base);
            for (const char* further : {"inherits", "references", "payload", "specializes"})
                if (base.metadata.contains(further)) {
                    prim.metadata[further] = base.metadata[further];
                    RAMURE_TRY(follow(prim, own, further, seen));
                }
        }
        return {};
    }

    const Layer& m_layer;
    std::vector<std::string>& m_notes;
    const LayerSource& m_others;
    std::size_t m_count = 0;
};

} // namespace

const Value* Attribute::get() const
{
    return value ? value.get() : samples.empty() ? nullptr : samples.begin()->second.get();
}

const Prim* Prim::child(std::string_view wanted) const
{
    const auto found =
        std::ranges::find(children, wanted, [](const auto& prim) -> std::string_view { return prim->name; });
    return found == children.end() ? nullptr : found->get();
}

const Attribute* Prim::attribute(const std::string& wanted) const
{
    const auto found = attributes.find(wanted);
    return found == attributes.end() ? nullptr : &found->second;
}

std::string Prim::text(const std::string& wanted) const
{
    const Attribute* found = attribute(wanted);
    const Value* value = found ? found->get() : nullptr;
    return value && !value->texts.empty() ? value->texts.front() : std::string();
}

std::string Prim::said(const std::string& wanted) const
{
    const auto found = metadata.find(wanted);
    return found == metadata.end() || found->second.texts.empty() ? std::string()
                                                                  : found->second.texts.front();
}

int componentsOf(std::string_view type)
{
    static const std::map<std::string_view, int> others{
        {"bool", 1},     {"uchar", 1},     {"int", 1},     {"uint", 1},   {"int64", 1},
        {"uint64", 1},   {"half", 1},      {"float", 1},   {"double", 1}, {"timecode", 1},
        {"string", 0},   {"token", 0},     {"asset", 0},   {"opaque", 0}, {"pathExpression", 0},
        {"group", 0},    {"quath", 4},     {"quatf", 4},   {"quatd", 4},  {"matrix2d", 4},
        {"matrix3d", 9}, {"matrix4d", 16}, {"frame4d", 16}};
    if (const auto found = others.find(type); found != others.end())
        return found->second;
    for (const std::string_view stem : {"half", "float", "double", "int"})
        if (type.size() == stem.size() + 1 && type.starts_with(stem) && type.back() >= '2' &&
            type.back() <= '4')
            return type.back() - '0';
    for (const std::string_view stem :
         {"point3", "vector3", "normal3", "color3", "color4", "texCoord2", "texCoord3"})
        if (type.size() == stem.size() + 1 && type.starts_with(stem) &&
            std::string_view("hfd").find(type.back()) != std::string_view::npos)
            return stem.back() - '0';
    return -1;
}

Expected<Layer> parseLayer(std::string_view text, const std::string& file, const Progress& progress)
{
    Scanner scanner(text);
    Layer out;
    if (LayerReader(scanner, progress).read(out))
        return out;
    Error error = scanner.problem();
    error.file = file;
    return fail(std::move(error));
}

/// Prims of layers below this one, which are weaker.
static void addSubLayers(Prim& root, const Prim& of, std::vector<std::string>& notes,
                         const LayerSource& others, int depth)
{
    const auto names = of.metadata.find("subLayers");
    for (const std::string& name :
         names == of.metadata.end() ? std::vector<std::string>() : names->second.texts) {
        const auto other = others && depth < deepestSubLayer ? others(name) : nullptr;
        if (!other) {
            notes.push_back(name);
            continue;
        }
        Prim prims = other->root;
        prims.metadata.clear();
        merge(root, prims);
        addSubLayers(root, other->root, notes, others, depth + 1);
    }
}

Expected<Layer> composed(const Layer& layer, std::vector<std::string>& notes, const LayerSource& others)
{
    Layer whole = layer;
    addSubLayers(whole.root, layer.root, notes, others, 0);
    Layer out = whole;
    Composer composer(whole, notes, others);
    for (auto& child : out.root.children) {
        child = std::make_shared<Prim>(*child);
        RAMURE_TRY(composer.compose(*child, "/" + child->name, 1));
    }
    return out;
}

static void relocate(Prim& prim, const std::string& asset, const std::filesystem::path& folder)
{
    const auto moved = [&](const std::string& name) { return (folder / name).lexically_normal().string(); };
    for (const char* arc : {"inherits", "references", "payload", "specializes", "subLayers"})
        if (const auto found = prim.metadata.find(arc); found != prim.metadata.end())
            for (std::string& text : found->second.texts)
                text = text.starts_with('/') ? asset + "<" + text : moved(text);
    for (auto& [name, attribute] : prim.attributes)
        if (attribute.type == "asset" && attribute.value) {
            auto own = std::make_shared<Value>(*attribute.value);
            for (std::string& text : own->texts)
                text = text.empty() ? text : moved(text);
            attribute.value = std::move(own);
        }
    for (const auto& child : prim.children)
        relocate(*child, asset, folder);
    for (Prim::VariantSet& set : prim.sets)
        for (auto& [name, body] : set.variants) {
            auto own = std::make_shared<Prim>(*body);
            relocate(*own, asset, folder);
            body = std::move(own);
        }
}

void relocate(Layer& layer, const std::string& asset)
{
    relocate(layer.root, asset, std::filesystem::path(asset).parent_path());
}

const Prim* primAt(const Prim& root, std::string_view path)
{
    const Prim* at = &root;
    while (at && path.size() > 1) {
        path.remove_prefix(1);
        const std::size_t end = std::min(path.find('/'), path.size());
        at = at->child(path.substr(0, end));
        path.remove_prefix(end);
    }
    return at;
}

} // namespace ramure::usd
