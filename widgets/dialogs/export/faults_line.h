/// \file
/// The line of the export dialog about meshes that are not clean, with the way to them.
#pragma once

#include "widgets/dialogs/export/mesh_faults.h"
#include <QWidget>
#include <optional>

class QLabel;

namespace ramure {

class FaultsLine : public QWidget
{
    Q_OBJECT
public:
    /// \param document must outlive the line
    explicit FaultsLine(const Document* document, QWidget* parent = nullptr);

    /// Null: nothing is known of crossings.
    void setAnalysis(const Analysis* analysis) { m_analysis = analysis; }
    /// Tells what is wrong with the meshes that these options choose. Without options no mesh is written.
    void look(const std::optional<ExportOptions>& options);
    /// The user has read what is wrong.
    [[nodiscard]] bool isAccepted() const { return !m_found.isEmpty() && m_found.text == m_accepted; }
    /// Returns false where a broken mesh has not been told before: it is written when this is asked again.
    [[nodiscard]] bool mayExport();

signals:
    void showRequested(ramure::NodeId tree);

private:
    const Document* m_document;
    const Analysis* m_analysis = nullptr;
    MeshFaults m_found;
    QString m_accepted; ///< the text that the user has read
    QLabel* m_text;
};

} // namespace ramure
