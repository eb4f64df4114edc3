#include "widgets/help/page_document.h"

#include "core/params/param_def.h"
#include "widgets/base/texts/search_text.h"
#include <QTextBlock>
#include <QTextDocument>
#include <QTextTable>
#include <algorithm>
#include <array>
#include <iterator>

namespace ramure {
namespace {

void nameBlock(const QTextBlock& block, const QString& anchor)
{
    QTextCursor cursor(block);
    cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
    QTextCharFormat format;
    format.setAnchor(true);
    format.setAnchorNames({anchor});
    cursor.mergeCharFormat(format);
}

QString anchorAt(const QTextBlock& block)
{
    const auto first = block.begin();
    return first.atEnd() ? QString() : first.fragment().charFormat().anchorNames().value(0);
}

/// "**Turn** `turtle.theta`": the key; else nothing.
QString paramAt(const QTextBlock& block)
{
    auto part = block.begin();
    if (part.atEnd() || part.fragment().charFormat().fontWeight() < QFont::Bold)
        return {};
    while (!part.atEnd() && !part.fragment().charFormat().fontFixedPitch())
        ++part;
    const QString key = part.atEnd() ? QString() : part.fragment().text();
    return findParam(key.toStdString()) ? key : QString();
}

bool beginsWord(const QString& text, const QString& word)
{
    qsizetype at = text.indexOf(word);
    while (at >= 0 && !isWordStart(text, at))
        at = text.indexOf(word, at + 1);
    return at >= 0;
}

/// Some words before and behind.
QString excerptAt(const QString& text, qsizetype hit)
{
    constexpr qsizetype before = 32, whole = 96;
    qsizetype from = std::max<qsizetype>(0, hit - before);
    if (from > 0)
        from = text.indexOf(u' ', from) + 1;
    const QString part = text.mid(from, whole).simplified();
    return (from > 0 ? QStringLiteral("… ") : QString()) + part +
           (from + whole < text.size() ? QStringLiteral(" …") : QString());
}

} // namespace

void namePlaces(QTextDocument& document, const HandbookPage& page)
{
    std::size_t next = 0;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() > 0 && next < page.headings.size())
            nameBlock(block, page.headings[next++].anchor);
        else if (const QString key = paramAt(block); !key.isEmpty())
            nameBlock(block, key);
    }
}

void paintPage(QTextDocument& document, const PageColours& colours)
{
    constexpr double padding = 5.0;
    const auto frames = document.rootFrame()->childFrames();
    for (QTextFrame* frame : frames) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table)
            continue;
        QTextTableFormat format = table->format();
        format.setBorder(1);
        format.setBorderCollapse(true);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(colours.line);
        format.setCellPadding(padding);
        format.setCellSpacing(0);
        table->setFormat(format);
    }
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (!block.blockFormat().hasProperty(QTextFormat::BlockCodeLanguage))
            continue;
        QTextBlockFormat format = block.blockFormat();
        format.setBackground(colours.code);
        QTextCursor(block).setBlockFormat(format);
    }
}

std::vector<HandbookSection> sectionsOf(const std::vector<HandbookPage>& pages)
{
    std::vector<HandbookSection> sections;
    for (const HandbookPage& page : pages) {
        QTextDocument document;
        document.setMarkdown(page.markdown);
        namePlaces(document, page);
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
            if (const QString anchor = anchorAt(block); !anchor.isEmpty()) {
                const QString title = block.text().section(QChar::LineSeparator, 0, 0);
                sections.push_back({page.id + u'#' + anchor, title, page.title(), {}});
            }
            if (!sections.empty())
                sections.back().text += block.text().replace(QChar::LineSeparator, u' ') + u' ';
        }
    }
    return sections;
}

std::vector<HandbookHit> searchSections(const std::vector<HandbookSection>& sections, const QString& typed)
{
    const QStringList words = searchWords(typed);
    enum { WordOfTitle, InTitle, WordOfText, InText, RankCount };
    std::array<std::vector<HandbookHit>, RankCount> hits;
    for (const HandbookSection& section : sections) {
        const QString text = searchable(section.text), title = searchable(section.title);
        const auto isIn = [](const QString& where) {
            return [&where](const QString& word) { return where.contains(word); };
        };
        const auto beginsIn = [](const QString& where) {
            return [&where](const QString& word) { return beginsWord(where, word); };
        };
        if (words.isEmpty() || !std::ranges::all_of(words, isIn(text)))
            continue;
        const auto rank = std::ranges::any_of(words, beginsIn(title))  ? WordOfTitle
                          : std::ranges::any_of(words, isIn(title))    ? InTitle
                          : std::ranges::all_of(words, beginsIn(text)) ? WordOfText
                                                                       : InText;
        const qsizetype behindTitle = text.indexOf(words.front(), section.title.size());
        hits[rank].push_back({section, excerptAt(section.text, std::max<qsizetype>(0, behindTitle))});
    }
    for (int rank = InTitle; rank < RankCount; ++rank)
        std::ranges::move(hits[static_cast<std::size_t>(rank)], std::back_inserter(hits[WordOfTitle]));
    return hits[WordOfTitle];
}

} // namespace ramure
