#include "widgets/actions/bookmark_actions.h"

#include "core/qt/document/commands.h"
#include "widgets/base/action_set.h"
#include "widgets/view/viewport.h"
#include "widgets/view/viewport_host.h"
#include <QLocale>
#include <QMenu>
#include <cmath>
#include <numbers>

namespace ramure {

ViewBookmark bookmarkOf(const Camera& camera)
{
    return {camera.target,   camera.distance, camera.yawRad,
            camera.pitchRad, camera.fovRad,   camera.orthographic};
}

Camera cameraOf(const ViewBookmark& bookmark)
{
    Camera camera;
    camera.target = bookmark.target;
    camera.distance = bookmark.distance;
    camera.yawRad = bookmark.yawRad;
    camera.pitchRad = bookmark.pitchRad;
    camera.fovRad = bookmark.fovRad;
    camera.orthographic = bookmark.orthographic;
    return camera;
}

BookmarkActions::BookmarkActions(Document* document, ViewportHost* host, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_host(host)
{
    for (std::size_t place = 0; place < viewBookmarkCount; ++place) {
        const auto add = [&](QList<QAction*>& list, const char* id, const QKeySequence& keys,
                             auto&& triggered) {
            auto* action = new QAction(this);
            action->setObjectName(QStringLiteral("%1%2").arg(QLatin1String(id)).arg(place + 1));
            action->setShortcut(keys);
            action->setEnabled(host->viewport() != nullptr);
            set->adopt(action);
            list += action;
            connect(action, &QAction::triggered, this, triggered);
        };
        const auto digit = static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(place));
        add(m_go, "view.bookmark.", QKeySequence(Qt::CTRL | digit), [this, place] { goTo(place); });
        // With Shift instead of Alt, keyboards that have their digits on Shift could not tell the two apart.
        add(m_keep, "view.keepBookmark.", QKeySequence(Qt::CTRL | Qt::ALT | digit),
            [this, place] { keep(place); });
        add(m_forget, "view.forgetBookmark.", {},
            [this, place] { (void)edit::setBookmark(*m_document, place, {}); });
    }
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeBookmarks | changeReset))
            update();
    });
    update();
}

void BookmarkActions::goTo(std::size_t place)
{
    Viewport* view = m_host->viewport();
    const auto& bookmark = m_document->scene().bookmarks()[place];
    if (bookmark && view)
        view->flyTo(cameraOf(*bookmark));
    else
        emit messageRaised(tr("There is no bookmark %1 yet: %2 keeps the present view there.")
                               .arg(place + 1)
                               .arg(m_keep[qsizetype(place)]->shortcut().toString(QKeySequence::NativeText)));
}

void BookmarkActions::keep(std::size_t place)
{
    Viewport* view = m_host->viewport();
    if (view && edit::setBookmark(*m_document, place, bookmarkOf(view->camera())))
        emit messageRaised(tr("The view is kept as bookmark %1: %2 comes back to it.")
                               .arg(place + 1)
                               .arg(m_go[qsizetype(place)]->shortcut().toString(QKeySequence::NativeText)));
}

/// From where a view looks, and how far away it is.
static QString placeText(const ViewBookmark& view)
{
    const QString sides[] = {BookmarkActions::tr("front"), BookmarkActions::tr("front right"),
                             BookmarkActions::tr("right"), BookmarkActions::tr("back right"),
                             BookmarkActions::tr("back"),  BookmarkActions::tr("back left"),
                             BookmarkActions::tr("left"),  BookmarkActions::tr("front left")};
    constexpr double steep = 0.7; // rad
    const auto eighth = static_cast<int>(std::lround(view.yawRad / (0.25 * std::numbers::pi)));
    const QString side = view.pitchRad > steep    ? BookmarkActions::tr("above")
                         : view.pitchRad < -steep ? BookmarkActions::tr("below")
                                                  : sides[((eighth % 8) + 8) % 8];
    return BookmarkActions::tr("%1, %2 m").arg(side, QLocale().toString(view.distance, 'g', 3));
}

void BookmarkActions::update()
{
    const ViewBookmarks& bookmarks = m_document->scene().bookmarks();
    bool any = false;
    for (std::size_t place = 0; place < viewBookmarkCount; ++place) {
        const auto i = qsizetype(place);
        const auto& bookmark = bookmarks[place];
        const QString what = bookmark ? placeText(*bookmark) : tr("empty");
        m_go[i]->setText(tr("Go to bookmark &%1: %2").arg(place + 1).arg(what));
        m_go[i]->setStatusTip(bookmark ? tr("Go back to this view")
                                       : tr("Nothing is kept here yet, see “Keep the view”"));
        m_keep[i]->setText(bookmark
                               ? tr("Keep the view as bookmark &%1, instead of %2").arg(place + 1).arg(what)
                               : tr("Keep the view as bookmark &%1").arg(place + 1));
        m_keep[i]->setStatusTip(tr("Keep the present view in the project"));
        m_forget[i]->setText(tr("Forget bookmark &%1").arg(place + 1));
        m_forget[i]->setVisible(bookmark.has_value());
        any = any || bookmark.has_value();
    }
    if (m_forgetMenu)
        m_forgetMenu->setEnabled(any);
}

void BookmarkActions::fillMenu(QMenu* menu)
{
    QMenu* own = menu->addMenu(tr("&Bookmarks"));
    own->addActions(m_go);
    own->addSeparator();
    own->addMenu(tr("&Keep the view"))->addActions(m_keep);
    m_forgetMenu = own->addMenu(tr("&Forget"));
    m_forgetMenu->addActions(m_forget);
    update();
}

} // namespace ramure
