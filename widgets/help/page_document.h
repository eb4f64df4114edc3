/// \file
/// A page of the handbook as a document: its places named, its looks those of the program; and cut into
/// sections for the search.
#pragma once

#include "widgets/help/handbook.h"
#include <QColor>

class QTextDocument;

namespace ramure {

struct PageColours
{
    QColor line; ///< around the cells of tables
    QColor code; ///< behind lines of code
};

/// Gives headings and parameters of \p page, which \p document was made from, their anchors.
void namePlaces(QTextDocument& document, const HandbookPage& page);
void paintPage(QTextDocument& document, const PageColours& colours);

struct HandbookSection
{
    QString place; ///< "grammar#the-turtle"
    QString title; ///< heading, or name of the parameter
    QString page;  ///< title of the page
    QString text;  ///< all of it
};
/// In the order of the pages.
std::vector<HandbookSection> sectionsOf(const std::vector<HandbookPage>& pages);

struct HandbookHit
{
    HandbookSection section;
    QString excerpt; ///< the words around the first hit
};
/// The sections that hold all words; those with a hit in the title first, whole words before
/// parts of words.
std::vector<HandbookHit> searchSections(const std::vector<HandbookSection>& sections, const QString& typed);

} // namespace ramure
