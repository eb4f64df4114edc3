#include "widgets/panels/presets/gallery_panel.h"

#include "core/qt/document/commands.h"
#include "core/qt/document/document.h"
#include "core/qt/session/jobs/planting.h"
#include "widgets/base/named.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/preset_title.h"
#include "widgets/panels/presets/picture_button.h"
#include "widgets/panels/presets/preset_gallery.h"
#include "widgets/view/tree_pictures.h"
#include <QAction>
#include <QDesktopServices>
#include <QFile>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QUrl>
#include <QVBoxLayout>
#include <cstring>

namespace ramure {
GalleryPanel::GalleryPanel(Document* document, Preferences* preferences, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_gallery(new PresetGallery(PictureButton::smallWidth, preferences, this))
    , m_problem(named(new QLabel(this), "problem"))
    , m_what(named(new QLabel(tr("Click: add to the scene"), this), "dim"))
    , m_add(new QAction(tr("&Add to the scene"), this))
    , m_new(new QAction(tr("&New scene with it"), this))
    , m_give(new QAction(tr("&Give its numbers to the selected trees"), this))
    , m_more(new QAction(tr("&More like this…"), this))
    , m_rename(new QAction(tr("&Rename…"), this))
    , m_remove(new QAction(tr("Move to the &trash"), this))
    , m_reveal(new QAction(tr("Show in the &folder"), this))
    , m_keep(new QPushButton(tr("&Save as preset…"), this))
{
    m_problem->setWordWrap(true);
    m_problem->hide();
    auto* content = new QWidget;
    auto* inside = layoutOf<QVBoxLayout>(content, -1, {8, 8, 8, 8});
    inside->addWidget(m_gallery);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus); // a press on what it shows gives the keys to the view
    scroll->setWidget(content);
    auto* layout = layoutOf<QVBoxLayout>(this);
    auto* above = layoutOf<QHBoxLayout>(nullptr, -1, {8, 8, 8, 0});
    m_what->setWordWrap(true);
    above->addWidget(m_what, 1);
    above->addWidget(m_keep);
    layout->addLayout(above);
    layout->addWidget(m_problem);
    layout->addWidget(scroll, 1);
    offerChoices();
}

void GalleryPanel::offerChoices()
{
    m_gallery->addChoice(m_add);
    m_gallery->addChoice(m_new);
    m_gallery->addChoice(m_give);
    m_gallery->addChoice(m_more);
    for (QAction* action : {m_rename, m_remove, m_reveal})
        m_gallery->addChoice(action, true);
    connect(m_keep, &QPushButton::clicked, this, &GalleryPanel::keep);
    connect(m_rename, &QAction::triggered, this, &GalleryPanel::rename);
    connect(m_remove, &QAction::triggered, this, &GalleryPanel::remove);
    connect(m_reveal, &QAction::triggered, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(m_own.folder())); });
    connect(m_gallery, &PresetGallery::chosen, this, &GalleryPanel::add);
    connect(m_add, &QAction::triggered, this, [this] { add(m_gallery->menuPreset()); });
    connect(m_new, &QAction::triggered, this, [this] { emit sceneRequested(m_gallery->menuPreset()); });
    connect(m_give, &QAction::triggered, this, [this] { give(m_gallery->menuPreset()); });
    connect(m_more, &QAction::triggered, this, [this] {
        if (const auto tree = namedTree(m_gallery->menuPreset()))
            emit moreRequested(*tree);
        else
            complain(tree.error());
    });
    connect(m_document, &Document::changed, this, &GalleryPanel::follow);
    m_gallery->setClickText(m_what->text());
    m_keep->setToolTip(tr("Keep the numbers of the selected tree among your own presets"));
    follow();
}

GalleryPanel::~GalleryPanel() = default;

QSize GalleryPanel::sizeHint() const
{
    return {300, 260};
}

void GalleryPanel::add(const QString& preset)
{
    const auto planted = namedTree(preset).and_then([this](Node&& tree) {
        giveTitle(tree);
        return edit::plantNode(*m_document, std::move(tree));
    });
    if (!planted)
        complain(planted.error());
}

void GalleryPanel::give(const QString& preset)
{
    const auto tree = namedTree(preset);
    if (!tree)
        return complain(tree.error());
    const QString name = presetTitle(QString::fromStdString(tree->name));
    const QString text = tr("Make it %1", "undo step; the name of a preset").arg(name);
    if (const auto given = edit::makeTreesLike(*m_document, targetTrees(*m_document), *tree, text); !given)
        complain(given.error());
}

void GalleryPanel::keep()
{
    const Node* tree = m_document->scene().find(targetTrees(*m_document).front());
    askName(tr("Save as preset"), m_own.freeName(spacedName(QString::fromStdString(tree->name))),
            [this, tree = *tree](const QString& name) {
                auto saved = m_own.save(name, tree);
                if (saved)
                    m_gallery->search()->clear(); // which might hide it
                return saved;
            });
}

void GalleryPanel::rename()
{
    const QString name = m_gallery->menuPreset().mid(int(std::strlen(OwnPresets::mark)));
    askName(tr("Rename preset"), name, [this, name](const QString& other) {
        const auto renamed = m_own.rename(name, other);
        if (renamed)
            m_gallery->followRename(QLatin1String(OwnPresets::mark) + name,
                                    QLatin1String(OwnPresets::mark) + other);
        return renamed;
    });
}

void GalleryPanel::remove()
{
    const auto removed = m_own.remove(m_gallery->menuPreset().mid(int(std::strlen(OwnPresets::mark))));
    refreshOwn();
    if (!removed)
        complain(removed.error());
}

/// Does not block.
void GalleryPanel::askName(const QString& title, const QString& suggestion,
                           std::function<Expected<void>(const QString&)> use)
{
    auto* dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->setLabelText(tr("Name:"));
    dialog->setTextValue(suggestion);
    constexpr int buttons = 180; // of the window's frame, beside its title
    dialog->setMinimumWidth(fontMetrics().horizontalAdvance(title) + buttons);
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this, use = std::move(use)](const QString& name) {
                const auto done = use(name.trimmed());
                refreshOwn();
                if (!done)
                    complain(done.error());
            });
    dialog->open();
}

void GalleryPanel::refreshOwn()
{
    m_problem->hide();
    m_gallery->showOwn(m_own);
    drawMissing();
}

/// One after another: of what was kept just now, and of files that somebody has put there.
void GalleryPanel::drawMissing()
{
    for (const QString& name : m_own.names()) {
        if (m_undrawn.contains(name) || QFile::exists(m_own.pictureFile(name)))
            continue;
        const auto tree = m_own.load(name);
        if (!tree) { // a click on it says why
            m_undrawn += name;
            continue;
        }
        if (!m_pictures)
            m_pictures = std::make_unique<TreePictures>();
        else if (m_pictures->isBusy())
            return;
        m_pictures->draw(tree->params, QSize(2 * PictureButton::usualWidth, 220),
                         [this, name](Expected<TreePicture>&& made) {
                             if (!made || !made->image.save(m_own.pictureFile(name)))
                                 m_undrawn += name;
                             m_gallery->showOwn(m_own);
                             QMetaObject::invokeMethod(this, &GalleryPanel::drawMissing,
                                                       Qt::QueuedConnection);
                         });
        return;
    }
}

void GalleryPanel::complain(const Error& error)
{
    m_problem->setText(errorText(error));
    m_problem->show();
}

void GalleryPanel::follow()
{
    m_problem->hide();
    const auto trees = targetTrees(*m_document);
    m_give->setEnabled(!trees.empty());
    m_keep->setEnabled(trees.size() == 1);
}

void GalleryPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refreshOwn();
}

} // namespace ramure
