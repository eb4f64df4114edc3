// Views that are kept.
#include "core/qt/document/document_command.h"

namespace ramure {

namespace {

class BookmarkCommand final : public DocumentCommand
{
public:
    BookmarkCommand(Document& document, std::size_t place, const std::optional<ViewBookmark>& view)
        : DocumentCommand(
              document, 0,
              (view ? DocumentCommand::tr("Keep Bookmark %1") : DocumentCommand::tr("Forget Bookmark %1"))
                  .arg(place + 1))
        , m_place(place)
        , m_view(view)
    {
    }
    void swap() override
    {
        Change change;
        change.kinds = changeBookmarks;
        document().applyChange(change, [this](Scene& scene) {
            ViewBookmarks bookmarks = scene.bookmarks();
            std::swap(bookmarks[m_place], m_view);
            scene.setBookmarks(bookmarks);
        });
    }
    void countMemory(MemoryCount& memory) const override { memory.add(sizeof(*this)); }

private:
    std::size_t m_place;
    std::optional<ViewBookmark> m_view;
};

} // namespace

Expected<void> edit::setBookmark(Document& document, std::size_t place,
                                 const std::optional<ViewBookmark>& view)
{
    if (place >= viewBookmarkCount)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there are nine places for views"));
    if (view)
        if (auto fine = checkViewBookmark(*view); !fine)
            return fine;
    if (document.scene().bookmarks()[place] != view)
        document.push(std::make_unique<BookmarkCommand>(document, place, view));
    return {};
}

} // namespace ramure
