#include "widgets/help/page_browser.h"

#include "widgets/base/texts/search_text.h"
#include "widgets/base/theme/theme.h"
#include "widgets/help/page_document.h"
#include <QEvent>
#include <QFileInfo>
#include <QImage>
#include <QStyle>
#include <algorithm>

namespace ramure {
namespace {

constexpr double pageMargin = 18.0;

QString idOf(const QUrl& url)
{
    return QFileInfo(url.path()).completeBaseName();
}

} // namespace

PageBrowser::PageBrowser(QWidget* parent)
    : QTextBrowser(parent)
{
    setOpenExternalLinks(true);
    setFrameShape(QFrame::NoFrame);
    document()->setDocumentMargin(pageMargin);
    connect(this, &QTextBrowser::sourceChanged, this, &PageBrowser::finishPage);
}

void PageBrowser::setPages(std::vector<HandbookPage> pages)
{
    m_pages = std::move(pages);
    if (m_shown.isValid())
        showPlace(page());
}

const HandbookPage* PageBrowser::find(const QString& id) const
{
    const auto found = std::ranges::find_if(m_pages, [&](const HandbookPage& page) { return page.id == id; });
    return found == m_pages.end() ? nullptr : &*found;
}

void PageBrowser::showPlace(const QString& place)
{
    const QString id = place.section(u'#', 0, 0);
    QUrl url(QStringLiteral("qrc:/handbook/%1/%2.md")
                 .arg(handbookLanguage(), find(id) ? id : QString::fromLatin1(firstHandbookPage)));
    if (place.contains(u'#'))
        url.setFragment(place.section(u'#', 1));
    setSource(url);
}

QString PageBrowser::page() const
{
    return idOf(m_shown);
}

void PageBrowser::mark(const QStringList& words)
{
    m_marked = words;
    showMarks();
}

void PageBrowser::doSetSource(const QUrl& url, QTextDocument::ResourceType)
{
    QTextBrowser::doSetSource(url, QTextDocument::MarkdownResource);
}

QVariant PageBrowser::loadResource(int type, const QUrl& url)
{
    if (type == QTextDocument::MarkdownResource) {
        const HandbookPage* page = find(idOf(url));
        return page ? page->markdown : QVariant();
    }
    QImage picture(QStringLiteral(":/handbook/%1/pictures/%2").arg(handbookLanguage(), url.fileName()));
    // The bar at the side may still have to come.
    const int room = viewport()->width() - static_cast<int>(2 * pageMargin) -
                     style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    if (picture.width() > room && room > 0)
        picture = picture.scaledToWidth(room, Qt::SmoothTransformation);
    return picture;
}

void PageBrowser::finishPage(const QUrl& url)
{
    m_shown = url;
    if (const HandbookPage* page = find(PageBrowser::page()))
        namePlaces(*document(), *page);
    QColor line = palette().color(QPalette::Text);
    constexpr float faint = 0.25F, fainter = 0.07F;
    line.setAlphaF(faint);
    QColor code = line;
    code.setAlphaF(fainter);
    paintPage(*document(), {line, code});
    showMarks();
    if (url.hasFragment())
        scrollToAnchor(url.fragment(QUrl::FullyDecoded));
}

void PageBrowser::showMarks()
{
    QList<ExtraSelection> marks;
    const QString text = searchable(document()->toPlainText());
    QColor colour = warningColour(palette());
    constexpr float soft = 0.4F;
    colour.setAlphaF(soft);
    for (const QString& word : m_marked)
        for (qsizetype at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + word.size())) {
            ExtraSelection mark;
            mark.cursor = QTextCursor(document());
            mark.cursor.setPosition(static_cast<int>(at));
            mark.cursor.setPosition(static_cast<int>(at + word.size()), QTextCursor::KeepAnchor);
            mark.format.setBackground(colour);
            marks += mark;
        }
    setExtraSelections(marks);
}

void PageBrowser::changeEvent(QEvent* event)
{
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_shown.isValid())
        finishPage(m_shown);
}

} // namespace ramure
