/// \file
/// Shows pages of the handbook, with links, a way back, and marks on what was searched for.
#pragma once

#include "widgets/help/handbook.h"
#include <QTextBrowser>

namespace ramure {

class PageBrowser : public QTextBrowser
{
    Q_OBJECT
public:
    explicit PageBrowser(QWidget* parent = nullptr);

    /// In another language: shows the present place anew.
    void setPages(std::vector<HandbookPage> pages);
    [[nodiscard]] const std::vector<HandbookPage>& pages() const { return m_pages; }
    /// "page" or "page#anchor"; what is not known opens the first page.
    void showPlace(const QString& place);
    /// The page on show; of source() Qt tells only after sourceChanged().
    [[nodiscard]] QString page() const;
    /// Marks these words (of searchWords()) on this and all later pages.
    void mark(const QStringList& words);

protected:
    void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override;
    QVariant loadResource(int type, const QUrl& url) override;
    void changeEvent(QEvent* event) override;

private:
    void finishPage(const QUrl& url);
    void showMarks();
    [[nodiscard]] const HandbookPage* find(const QString& id) const;

    std::vector<HandbookPage> m_pages;
    QUrl m_shown;
    QStringList m_marked;
};

} // namespace ramure
