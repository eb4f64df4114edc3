/// \file
/// The lines of an OBJ file one after the other. Internal to core/io: obj_scan.h is what readers use.
#pragma once

#include "core/base/large_buffer.h"
#include "core/io/formats/text/obj_scan.h"
#include "core/io/mesh_mending.h"

namespace ramure::reading {

inline constexpr Index maxObjVertices = noIndex - 1;

/// Does a keyword or a number end before it?
inline bool endsWord(char c)
{
    return isBlank(c) || c == '\n' || c == '\\';
}

/// Fills the lists from blocks of whole lines, each of which ends in a line feed. Where a call says false,
/// takeError() says why.
class ObjScanner
{
public:
    ObjScanner(const std::string& file, std::size_t bytes, const Progress& progress, const glm::dvec3& origin)
        : m_file(file)
        , m_progress(progress)
        , m_origin(origin)
        , m_isFar(origin != glm::dvec3(0.0))
        , m_bytes(std::max<std::size_t>(bytes, 1))
    {
        // Typical sizes of lines: memory that stays untouched costs nothing.
        reserveHuge(m_lists.positions, bytes / 72);
        reserveHuge(m_lists.triangles, bytes / 36);
    }
    bool scan(std::string_view block);
    /// \param padding bytes behind the text that were left out
    bool finish(std::size_t padding);
    ObjLists takeLists() { return std::move(m_lists); }
    Error takeError() { return std::move(*m_error); }

private:
    bool scanLine();
    bool scanPosition();
    bool scanCoordinate(int axis, float& value);
    void scanColour();
    void scanPolypaint();
    void scanNormal();
    bool scanFace();
    bool scanCorner(Index& vertex, Index& texture);
    void scanTexture();
    void addTexture(const glm::uvec3& corners);
    void finishTexture();
    bool scanCornerNormal(Index vertex, bool& hasNormal);
    void finishNormals();
    void setNormal(Index vertex, Index normal);
    void scanMark(std::vector<ObjMark>& marks);
    bool scanOther();
    void skipTransformNumbers();

    void skipBlanks()
    {
        do
            while (isBlank(*m_at))
                ++m_at;
        while (*m_at == '\\' && skipContinuation());
    }
    bool skipContinuation();
    void skipLine();
    std::string_view restOfLine();
    bool fail(ErrorCode code, const char* text, std::vector<std::string> args = {});

    const std::string& m_file;
    const Progress& m_progress;
    glm::dvec3 m_origin; ///< is subtracted from positions
    bool m_isFar;
    std::size_t m_bytes;
    std::size_t m_bytesDone = 0;
    ObjLists m_lists;
    std::optional<Error> m_error;

    const char* m_at = nullptr;
    const char* m_end = nullptr;
    int m_line = 0;
    Index m_face[2] = {};        ///< of the face being scanned, the first corner and the one before
    Index m_faceTexture[2] = {}; ///< the same for texture coordinates
    int m_corners = 0;           ///< and how many there were
    PolygonList m_polygons;
    std::vector<glm::vec3> m_polypaint; ///< colours that ZBrush puts into comments
    int m_badTextureLine = 0;           ///< where the first texture coordinate is that nobody can use
    int m_badNormalLine = 0;            ///< and the first normal
    std::int64_t m_missingNormal = 0;   ///< that the corner at m_missingNormalLine names
    int m_transformNumbers = 0;         ///< how many numbers the matrix of the TRANSFORM line still lacks
    // References to what the file has not given yet are checked at its end.
    std::int64_t m_largestVertex = 0, m_largestNormal = 0;
    int m_largestVertexLine = 0, m_largestNormalLine = 0, m_missingNormalLine = 0;
    struct Skipped
    {
        int firstLine;
        int count;
    };
    std::map<std::string, Skipped, std::less<>> m_skipped;
};

} // namespace ramure::reading
