#include "core/io/formats/glb/glb_variants.h"

#include <algorithm>

namespace ramure::glb {

static constexpr const char* extension = "KHR_materials_variants";

std::size_t Variants::numberOf(const std::string& name)
{
    const auto found = std::ranges::find(m_names, name);
    const auto number = static_cast<std::size_t>(found - m_names.begin());
    if (found == m_names.end())
        m_names.push_back(name);
    return number;
}

void Variants::tell(Json& primitive, const ExportSeasons& seasons, const std::vector<std::size_t>& materials)
{
    Json mappings = Json::array();
    for (std::size_t i = 0; i < seasons.variants.size(); ++i)
        mappings.push_back(
            {{"material", materials[i]}, {"variants", Json::array({numberOf(seasons.variants[i].name)})}});
    if (!mappings.empty())
        primitive["extensions"][extension]["mappings"] = std::move(mappings);
}

void Variants::addTo(Json& root) const
{
    if (m_names.empty())
        return;
    Json names = Json::array();
    for (const std::string& name : m_names)
        names.push_back({{"name", name}});
    root["extensions"][extension]["variants"] = std::move(names);
    root["extensionsUsed"].push_back(extension);
}

std::vector<glm::vec1> phasesOf(const ExportSeasons& seasons, const std::vector<Index>& from,
                                std::size_t vertices)
{
    std::vector<glm::vec1> phases;
    const std::size_t each = seasons.phases.empty() ? 0 : vertices / seasons.phases.size();
    if (each == 0)
        return phases;
    phases.reserve(from.size());
    for (const Index vertex : from)
        phases.emplace_back(seasons.phases[std::min(vertex / each, seasons.phases.size() - 1)]);
    return phases;
}

} // namespace ramure::glb
