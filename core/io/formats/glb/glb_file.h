/// \file
/// A GLB file as it is read: its JSON, its buffers, and the numbers of its accessors, checked. Internal to
/// the formats. Names are those of the glTF 2.0 specification (Khronos Group, 2021).
#pragma once

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/io/read_parts.h"
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ramure::glb {

using Json = nlohmann::json;

/// "nodes[3]": where in the JSON something stands.
std::string placeOf(const char* list, std::size_t number);
/// An error with its place inside the file.
tl::unexpected<Error> wrong(const std::string& place, const char* text, std::vector<std::string> args = {},
                            ErrorCode code = ErrorCode::Invalid);

/// \name Members of a JSON object, which may be anything
/// \{
const Json* member(const Json& object, const char* name); ///< null where there is none
std::string textOf(const Json& object, const char* name); ///< empty where it is no text
/// A whole number from 0 on, or nothing.
std::optional<std::size_t> numberOf(const Json& object, const char* name);
/// Reads as many finite numbers as \p out has places. If there is no such member, \p out stays as it is.
/// Error: Invalid.
Expected<void> numbersOf(const Json& object, const char* name, std::span<double> out,
                         const std::string& place);
/// \}

class File
{
public:
    /// Errors: Io; Syntax (no GLB of version 2, cut off, broken JSON); Limit (JSON of more than 256 MiB, a
    /// cut of what a file may hold); Unknown (an extension that the file requires, that is about more than
    /// materials and pictures, and that the program does not know); Cancelled.
    static Expected<File> open(const std::string& path, const Progress& progress);

    /// What stands at the top: "nodes", "meshes" ... An empty list where it is none.
    [[nodiscard]] const Json& list(const char* name) const;
    [[nodiscard]] const Json& root() const { return m_root; }
    /// What of the file as a whole was left out.
    [[nodiscard]] const std::vector<std::string>& notes() const { return m_notes; }
    /// An element of a list. Error: Invalid, there is no such element, or it is no object.
    Expected<const Json*> element(const char* listName, std::optional<std::size_t> number,
                                  const std::string& place) const;

    /// The values of an accessor, \p components for each element, normalised ones as numbers from 0 or -1 to
    /// 1. Errors: Invalid (another type, beyond its view), Limit (more than a mesh can be), Unknown.
    Expected<std::vector<float>> floats(std::optional<std::size_t> accessor, std::size_t components,
                                        const std::string& place);
    /// The same, and some may not be finite.
    Expected<std::vector<float>> anyFloats(std::optional<std::size_t> accessor, std::size_t components,
                                           const std::string& place);
    /// Whole numbers as they are.
    Expected<std::vector<Index>> indices(std::optional<std::size_t> accessor, std::size_t components,
                                         const std::string& place);
    /// The bytes of a view as they are in the file, or unpacked.
    Expected<std::string_view> view(std::optional<std::size_t> number, const std::string& place);
    /// How many numbers an element of it has; 0: there is no such accessor.
    [[nodiscard]] std::size_t components(std::optional<std::size_t> accessor) const;

private:
    struct Accessor;
    Expected<void> split();
    Expected<void> parse(std::string_view text);
    Expected<void> checkExtensions() const;
    Expected<std::string_view> buffer(std::optional<std::size_t> number, const std::string& place);
    Expected<std::string_view> unpacked(std::size_t number, const Json& extension);
    Expected<Accessor> accessor(std::optional<std::size_t> number, std::size_t components,
                                const std::string& place);
    template <class T>
    Expected<std::vector<T>> values(std::optional<std::size_t> number, std::size_t components,
                                    const std::string& place);
    template <class T>
    Expected<void> addSparse(std::vector<T>& to, const Accessor& accessor, std::size_t components,
                             const std::string& place);

    std::string m_bytes;      ///< the whole file
    std::string_view m_chunk; ///< its binary part
    Json m_root;
    std::vector<std::string> m_notes;
    std::map<std::size_t, std::string> m_buffers; ///< those that stand in the JSON as text
    std::map<std::size_t, std::string> m_views;   ///< that were unpacked
    std::size_t m_unpacked = 0;
};

} // namespace ramure::glb
