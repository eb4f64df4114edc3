#include "widgets/dialogs/export/faults_line.h"

#include "widgets/base/named.h"
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>

namespace ramure {

FaultsLine::FaultsLine(const Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_text(named(new QLabel(this), "meshFaults"))
{
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    auto* show = named(new QPushButton(tr("Show"), this), "showFaults");
    show->setAutoDefault(false);
    auto* row = layoutOf<QHBoxLayout>(this, 8);
    row->addWidget(m_text, 1);
    row->addWidget(show, 0, Qt::AlignTop);
    connect(show, &QPushButton::clicked, this, [this] { emit showRequested(m_found.tree); });
}

void FaultsLine::look(const std::optional<ExportOptions>& options)
{
    m_found = options ? meshFaults(*m_document, m_analysis, *options) : MeshFaults();
    m_text->setText(m_found.text);
    m_text->setProperty("broken", m_found.mustAsk());
    m_text->style()->unpolish(m_text);
    m_text->style()->polish(m_text);
    setVisible(!m_found.isEmpty());
}

bool FaultsLine::mayExport()
{
    if (!m_found.mustAsk() || isAccepted())
        return true;
    m_accepted = m_found.text;
    return false;
}

} // namespace ramure
