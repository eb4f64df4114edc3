#include "widgets/window/welcome_panel.h"

#include "core/qt/document/project/own_presets.h"
#include "widgets/actions/file_actions.h"
#include "widgets/base/action_list.h"
#include "widgets/base/action_set.h"
#include "widgets/base/named.h"
#include "widgets/base/theme/icons.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/panels/presets/picture_button.h"
#include "widgets/panels/presets/preset_gallery.h"
#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>

namespace ramure {
namespace {

constexpr int shownFiles = 5;
constexpr int sideMargin = 20;
constexpr int shownText = 340; ///< pixels of a file's name, before it is cut

/// What to try first, by the ids of actions.
constexpr const char* firstKeys[] = {"edit.newTree", "view.frameAll", "help.find", "file.export",
                                     "help.handbook"};

} // namespace

WelcomePanel::WelcomePanel(FileActions* files, ActionSet* set, Preferences* preferences, QWidget* parent)
    : QFrame(parent)
    , m_files(files)
    , m_set(set)
    , m_preferences(preferences)
    , m_page(new QWidget)
    , m_close(new QToolButton(m_page))
    , m_gallery(new PresetGallery(PictureButton::usualWidth, preferences, m_page))
    , m_add(new QAction(tr("&Add to the scene"), this))
    , m_recent(new QVBoxLayout)
    , m_open(new QPushButton(tr("Open a file…"), m_page))
    , m_hints(new QGridLayout)
    , m_atStart(new QCheckBox(tr("Show this page at the start"), this))
{
    setObjectName(QStringLiteral("welcome"));
    build();
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
    // The page stays: one may look at several.
    connect(m_gallery, &PresetGallery::chosen, m_files,
            [this](const QString& name) { m_files->newFromPreset(name); });
    m_gallery->addChoice(m_add);
    connect(m_add, &QAction::triggered, this, [this] { emit addRequested(m_gallery->menuPreset()); });
    connect(m_open, &QPushButton::clicked, m_files, &FileActions::open);
    connect(m_files, &FileActions::openEnded, this, [this](bool opened) {
        if (opened)
            hide();
    });
    connect(m_atStart, &QCheckBox::toggled, m_preferences,
            [this](bool on) { m_preferences->welcomeAtStart.set(on); });
    connect(m_preferences, &Preferences::changed, this, &WelcomePanel::takePreferences);
    takePreferences();
    hide();
}

QLabel* WelcomePanel::heading(const QString& text)
{
    auto* label = named(new QLabel(text, m_page), "panelTitle");
    return label;
}

void WelcomePanel::build()
{
    auto* title = named(new QLabel(tr("Welcome to Ramure"), m_page), "welcomeTitle");
    auto* intro = named(
        new QLabel(tr("From a grammar to one clean mesh. The tree beside this page is ready to be changed."),
                   m_page),
        "dim");
    intro->setWordWrap(true);
    m_close->setAutoRaise(true);
    m_close->setIcon(icon("close"));
    m_close->setIconSize({14, 14});
    m_close->setToolTip(tr("Close this page (File menu: Welcome page)"));
    m_close->setAccessibleName(tr("Close"));
    m_gallery->setClickText(tr("Click: new scene with it"));
    m_open->setAutoDefault(false);
    m_open->setObjectName(QStringLiteral("welcomeOpen"));
    m_atStart->setObjectName(QStringLiteral("welcomeAtStart"));
    auto* page = layoutOf<QVBoxLayout>(m_page, 6, {sideMargin, 14, sideMargin, 10});
    auto* top = new QHBoxLayout;
    top->addWidget(title, 1);
    top->addWidget(m_close, 0, Qt::AlignTop);
    page->addLayout(top);
    page->addWidget(intro);
    page->addSpacing(6);
    page->addWidget(heading(tr("Begin a new scene with a tree")));
    page->addWidget(m_gallery);
    page->addSpacing(6);
    page->addWidget(heading(tr("Recent files")));
    m_recent->setSpacing(0);
    page->addLayout(m_recent);
    page->addWidget(m_open, 0, Qt::AlignLeft);
    page->addSpacing(6);
    page->addWidget(heading(tr("Keys to begin with")));
    m_hints->setHorizontalSpacing(16);
    m_hints->setVerticalSpacing(4);
    m_hints->setColumnStretch(1, 1);
    page->addLayout(m_hints);
    page->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_page);
    auto* layout = layoutOf<QVBoxLayout>(this, 0);
    layout->addWidget(scroll, 1);
    auto* foot = layoutOf<QHBoxLayout>(nullptr, -1, {sideMargin, 8, sideMargin, 8});
    foot->addWidget(m_atStart);
    layout->addLayout(foot);
}

void WelcomePanel::open()
{
    fillRecent();
    m_gallery->showOwn(OwnPresets());
    fillHints();
    setFixedWidth(m_page->sizeHint().width() + 14);
    show();
    if (QWidget* first = m_gallery->first())
        first->setFocus();
}

void WelcomePanel::takePreferences()
{
    m_atStart->setChecked(m_preferences->welcomeAtStart());
    if (isVisible() && m_preferences->recentFiles().mid(0, shownFiles) != m_shownRecent)
        fillRecent();
}

void WelcomePanel::fillRecent()
{
    while (const QLayoutItem* item = m_recent->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    m_shownRecent = m_preferences->recentFiles().mid(0, shownFiles);
    for (const QString& path : m_shownRecent) {
        auto* button = named(new QToolButton(m_page), "welcomeFile");
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setIcon(icon("tree"));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        const QString name =
            button->fontMetrics().elidedText(QFileInfo(path).fileName(), Qt::ElideMiddle, shownText);
        button->setText(QString(name).replace(u'&', QStringLiteral("&&")));
        button->setToolTip(QDir::toNativeSeparators(path));
        connect(button, &QToolButton::clicked, m_files, [this, path] { m_files->openFile(path); });
        m_recent->addWidget(button, 0, Qt::AlignLeft);
    }
    if (m_shownRecent.isEmpty()) {
        auto* none = named(new QLabel(tr("No files yet"), m_page), "dim");
        m_recent->addWidget(none);
    }
}

void WelcomePanel::fillHints()
{
    while (const QLayoutItem* item = m_hints->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    int row = 0;
    for (const char* id : firstKeys) {
        const QAction* action = m_set->find(QLatin1String(id));
        if (!action || action->shortcut().isEmpty())
            continue;
        auto* keys =
            named(new QLabel(action->shortcut().toString(QKeySequence::NativeText), m_page), "keyCap");
        auto* text = new QLabel(plainText(action->text()), m_page);
        m_hints->addWidget(keys, row, 0, Qt::AlignLeft);
        m_hints->addWidget(text, row++, 1);
    }
}

void WelcomePanel::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        hide();
    else
        QFrame::keyPressEvent(event);
}

void WelcomePanel::hideEvent(QHideEvent* event)
{
    QFrame::hideEvent(event);
    if (!event->spontaneous())
        emit closed();
}

} // namespace ramure
