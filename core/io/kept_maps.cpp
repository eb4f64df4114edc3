#include "core/io/kept_maps.h"

#include "core/pipeline/stage_hashes.h"
#include <algorithm>
#include <list>
#include <mutex>

namespace ramure {
namespace {

constexpr std::size_t mostKeptBytes = std::size_t(64) << 20;

struct Kept
{
    std::string key;
    std::vector<MadeMap> maps;
};

struct Shelf
{
    std::mutex mutex;
    std::list<Kept> kept; ///< the one that was asked for last stands first
    std::size_t bytes = 0;
};

Shelf& shelf()
{
    static Shelf only;
    return only;
}

std::size_t bytesOf(const std::vector<MadeMap>& maps)
{
    std::size_t sum = 0;
    for (const MadeMap& map : maps)
        sum += map.png.size();
    return sum;
}

auto place(Shelf& shelf, const MapsKey& key)
{
    return std::ranges::find(shelf.kept, key.text(), &Kept::key);
}

std::string ending(int size, std::span<const MaterialMap> kinds)
{
    std::string text = std::to_string(size);
    for (const MaterialMap kind : kinds)
        text.append(" ").append(std::to_string(int(kind)));
    return text;
}

} // namespace

MapsKey::MapsKey(const BarkParams& bark, int size, std::span<const MaterialMap> kinds)
    : m_text("bark " + std::to_string(barkHash(bark)) + ' ' + ending(size, kinds))
{
}

MapsKey::MapsKey(LeafShape leaf, int season, int size, std::span<const MaterialMap> kinds)
    : m_text("leaf " + std::to_string(int(leaf)) + ' ' + std::to_string(season) + ' ' + ending(size, kinds))
{
}

std::optional<std::vector<MadeMap>> findKeptMaps(const MapsKey& key)
{
    Shelf& all = shelf();
    const std::scoped_lock lock(all.mutex);
    const auto found = place(all, key);
    if (found == all.kept.end())
        return std::nullopt;
    all.kept.splice(all.kept.begin(), all.kept, found);
    return found->maps;
}

void keepMaps(const MapsKey& key, const std::vector<MadeMap>& maps)
{
    Shelf& all = shelf();
    const std::scoped_lock lock(all.mutex);
    const std::size_t bytes = bytesOf(maps);
    if (bytes > mostKeptBytes || place(all, key) != all.kept.end())
        return;
    all.kept.push_front({key.text(), maps});
    all.bytes += bytes;
    while (all.bytes > mostKeptBytes) {
        all.bytes -= bytesOf(all.kept.back().maps);
        all.kept.pop_back();
    }
}

} // namespace ramure
