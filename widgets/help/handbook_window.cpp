#include "widgets/help/handbook_window.h"

#include "widgets/base/named.h"
#include "widgets/base/texts/search_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/help/page_browser.h"
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr int placeRole = Qt::UserRole;
constexpr QSize startSize(1060, 760);
constexpr int contentsWidth = 270;
constexpr int listedLevel = 2; ///< of headings in the contents

QString placeOf(const QTreeWidgetItem* item)
{
    return item ? item->data(0, placeRole).toString() : QString();
}

} // namespace

HandbookWindow::HandbookWindow()
    : m_back(new QToolButton(this))
    , m_forward(new QToolButton(this))
    , m_start(new QToolButton(this))
    , m_search(new QLineEdit(this))
    , m_lists(new QStackedWidget(this))
    , m_contents(new QTreeWidget(this))
    , m_found(new QTreeWidget(this))
    , m_browser(new PageBrowser(this))
{
    setObjectName(QStringLiteral("handbook"));
    setAttribute(Qt::WA_QuitOnClose, false);
    build();
    connect(m_back, &QToolButton::clicked, m_browser, &QTextBrowser::backward);
    connect(m_forward, &QToolButton::clicked, m_browser, &QTextBrowser::forward);
    connect(m_start, &QToolButton::clicked, this,
            [this] { m_browser->showPlace(QString::fromLatin1(firstHandbookPage)); });
    connect(m_browser, &QTextBrowser::backwardAvailable, m_back, &QWidget::setEnabled);
    connect(m_browser, &QTextBrowser::forwardAvailable, m_forward, &QWidget::setEnabled);
    connect(m_browser, &QTextBrowser::sourceChanged, this, &HandbookWindow::follow);
    connect(m_search, &QLineEdit::textChanged, this, &HandbookWindow::search);
    for (QTreeWidget* list : {m_contents, m_found})
        connect(list, &QTreeWidget::currentItemChanged, this, &HandbookWindow::openItem);
    m_browser->setPages(readHandbook());
    fillContents();
    resize(startSize);
}

void HandbookWindow::build()
{
    auto* bar = layoutOf<QHBoxLayout>(nullptr, -1, {8, 6, 8, 6});
    const std::tuple<QToolButton*, const char*, QString> buttons[] = {
        {m_back, "back", tr("Back (Alt+Left)")},
        {m_forward, "forward", tr("Forward (Alt+Right)")},
        {m_start, "handbook", tr("First page")}};
    for (const auto& [button, name, tip] : buttons) {
        button->setIcon(icon(name));
        button->setToolTip(tip);
        button->setAutoRaise(true);
        bar->addWidget(button);
    }
    m_back->setEnabled(false);
    m_forward->setEnabled(false);
    m_search->setObjectName(QStringLiteral("handbookSearch"));
    m_search->setPlaceholderText(tr("Search all pages"));
    m_search->setAccessibleName(tr("Search all pages"));
    m_browser->setAccessibleName(tr("Page"));
    m_contents->setAccessibleName(tr("Contents"));
    m_found->setAccessibleName(tr("Found"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_search->installEventFilter(this);
    bar->addWidget(m_search, 1);
    m_contents->setObjectName(QStringLiteral("handbookContents"));
    m_found->setObjectName(QStringLiteral("handbookFound"));
    m_found->setRootIsDecorated(false);
    for (QTreeWidget* list : {m_contents, m_found}) {
        list->setHeaderHidden(true);
        m_lists->addWidget(list);
    }
    auto* parts = new QSplitter(this);
    parts->addWidget(m_lists);
    parts->addWidget(m_browser);
    parts->setStretchFactor(1, 1);
    parts->setSizes({contentsWidth, startSize.width() - contentsWidth});
    auto* layout = layoutOf<QVBoxLayout>(this, 0);
    layout->addLayout(bar);
    layout->addWidget(parts, 1);
}

void HandbookWindow::fillContents()
{
    const QSignalBlocker quiet(m_contents);
    m_contents->clear();
    for (const HandbookPage& page : m_browser->pages()) {
        auto* top = new QTreeWidgetItem(m_contents, {page.title()});
        top->setData(0, placeRole, page.id);
        for (const HandbookHeading& heading : page.headings) {
            if (heading.level != listedLevel)
                continue;
            auto* below = new QTreeWidgetItem(top, {heading.text});
            below->setData(0, placeRole, QString(page.id + u'#' + heading.anchor));
        }
    }
    follow();
}

/// The contents show where the reader is.
void HandbookWindow::follow()
{
    const QString page = m_browser->page();
    const QSignalBlocker quiet(m_contents);
    for (int i = 0; i < m_contents->topLevelItemCount(); ++i) {
        QTreeWidgetItem* top = m_contents->topLevelItem(i);
        if (placeOf(top) != page)
            continue;
        setWindowTitle(tr("%1 – Handbook of Ramure").arg(top->text(0)));
        top->setExpanded(true);
        if (placeOf(m_contents->currentItem()).section(u'#', 0, 0) != page)
            m_contents->setCurrentItem(top);
    }
}

void HandbookWindow::showPlace(const QString& place)
{
    show();
    raise();
    activateWindow();
    m_browser->showPlace(place);
    focusSearch();
}

void HandbookWindow::focusSearch()
{
    m_search->setFocus();
    m_search->selectAll();
}

void HandbookWindow::openItem(const QTreeWidgetItem* item)
{
    if (item)
        m_browser->showPlace(placeOf(item));
}

void HandbookWindow::search(const QString& typed)
{
    constexpr int leastLetters = 2;
    const bool searching = typed.trimmed().size() >= leastLetters;
    m_lists->setCurrentWidget(searching ? m_found : m_contents);
    m_browser->mark(searching ? searchWords(typed) : QStringList());
    if (!searching)
        return;
    if (m_sections.empty())
        m_sections = sectionsOf(m_browser->pages());
    const QSignalBlocker quiet(m_found);
    m_found->clear();
    for (const HandbookHit& hit : searchSections(m_sections, typed)) {
        const QString head = hit.section.title == hit.section.page
                                 ? hit.section.title
                                 : hit.section.title + QStringLiteral(" – ") + hit.section.page;
        auto* item = new QTreeWidgetItem(m_found, {head + u'\n' + hit.excerpt});
        item->setData(0, placeRole, hit.section.place);
    }
    if (m_found->topLevelItemCount() == 0) {
        auto* none = new QTreeWidgetItem(m_found, {tr("Nothing found")});
        none->setFlags(Qt::NoItemFlags);
    }
}

/// Through what was found or the contents, while the field keeps the keys.
void HandbookWindow::step(bool down)
{
    auto* list = static_cast<QTreeWidget*>(m_lists->currentWidget());
    const QTreeWidgetItem* at = list->currentItem();
    QTreeWidgetItem* next = !at ? list->topLevelItem(0) : down ? list->itemBelow(at) : list->itemAbove(at);
    if (next)
        list->setCurrentItem(next);
}

bool HandbookWindow::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_search || event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        QCoreApplication::sendEvent(m_browser, event); // the page is read from there
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Down:
        step(true);
        return true;
    case Qt::Key_Up:
        step(false);
        return true;
    default:
        return false;
    }
}

void HandbookWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Find) || event->matches(QKeySequence::HelpContents)) {
        focusSearch();
    } else if (event->key() == Qt::Key_Escape && !m_search->text().isEmpty()) {
        m_search->clear();
    } else if (event->key() == Qt::Key_Escape) {
        close();
    } else if (event->matches(QKeySequence::Back)) {
        m_browser->backward();
    } else if (event->matches(QKeySequence::Forward)) {
        m_browser->forward();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace ramure
