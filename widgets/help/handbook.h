/// \file
/// The pages of the handbook (resources/handbook), which the program carries in each of its languages. Places
/// are named "page" or "page#anchor", the same in all languages: anchors come from the English headings as
/// GitHub makes them, and are the keys on the page of the parameters.
#pragma once

#include <QString>
#include <vector>

namespace ramure {

struct HandbookHeading
{
    int level = 1; ///< 1: the page's title
    QString text;  ///< in the page's language, without marks
    QString anchor;
};

struct HandbookPage
{
    QString id;       ///< "grammar"
    QString markdown; ///< in the page's language
    std::vector<HandbookHeading> headings;
    bool isTask = false; ///< how something is done, not what there is

    [[nodiscard]] QString title() const { return headings.empty() ? id : headings.front().text; }
};

inline constexpr const char* firstHandbookPage = "index";

/// "en" or "fr": the language of the interface, where there are pages in it.
QString handbookLanguage();
/// All pages in the language of the interface and in reading order. The page of the parameters is made from
/// their table.
std::vector<HandbookPage> readHandbook();
/// The name that GitHub gives the place of a heading.
QString headingAnchor(const QString& heading);
/// The headings of a text in Markdown, with the anchors of its own language.
std::vector<HandbookHeading> headingsOf(const QString& markdown);

} // namespace ramure
