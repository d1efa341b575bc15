<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ChangesText</name>
    <message>
        <source>this mission</source>
        <translation>diese Mission</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>weg</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 m</source>
        <translation>%1 × %2 × %3 m</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3 m</source>
        <translation>x %1, y %2, z %3 m</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>Was sich geändert hat</translation>
    </message>
    <message>
        <source>Between %1 and %2: %3 came, %4 went. Listed is what one visit&apos;s scans have where the other&apos;s looked through; what was not looked at both times is not compared.</source>
        <translation>Zwischen %1 und %2: %3 kamen hinzu, %4 sind weg. Genannt wird, was Scans des einen Besuchs haben, wo die des anderen hindurchsahen; was nicht beide Male gesehen wurde, ist nicht verglichen.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Size, along x, y and z</source>
        <translation>Größe entlang x, y und z</translation>
    </message>
    <message>
        <source>Middle, and its lowest z</source>
        <translation>Mitte, und tiefstes z</translation>
    </message>
    <message>
        <source>and %1 smaller ones</source>
        <translation>und %1 kleinere</translation>
    </message>
</context>
<context>
    <name>CoverageText</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Infrared</source>
        <translation>Infrarot</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>Scanner</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>%1 m² at x %2, y %3</source>
        <translation>%1 m² bei x %2, y %3</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Searched</source>
        <translation>Abgesucht</translation>
    </message>
    <message>
        <source>Of %1 m² of floor that the robots can reach. Seen is where a body on the floor would span enough pixels or points.</source>
        <translation>Von %1 m² Boden, den die Roboter erreichen. Gesehen heißt: ein Körper am Boden hätte dort genug Pixel oder Punkte.</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Gesehen</translation>
    </message>
    <message>
        <source>Missed, the largest first</source>
        <translation>Übersehen, das Größte zuerst</translation>
    </message>
    <message>
        <source>%1 m², %2 %</source>
        <translation>%1 m², %2 %</translation>
    </message>
    <message>
        <source>%1 m² at x %2, y %3, storey %4</source>
        <translation>%1 m² bei x %2, y %3, Stockwerk %4</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Storey</source>
        <translation>Stockwerk</translation>
    </message>
    <message>
        <source>Can be reached</source>
        <translation>Erreichbar</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
</context>
<context>
    <name>CurveText</name>
    <message>
        <source>CO₂ measured by %1</source>
        <translation>CO₂, gemessen von %1</translation>
    </message>
    <message>
        <source>CO₂ [ppm]</source>
        <translation>CO₂ [ppm]</translation>
    </message>
    <message>
        <source>time of day</source>
        <translation>Uhrzeit</translation>
    </message>
</context>
<context>
    <name>EvidenceText</name>
    <message>
        <source>, 15 to 40 °C, hottest %1 °C</source>
        <translation>, 15 bis 40 °C, am wärmsten %1 °C</translation>
    </message>
    <message>
        <source>scan of %1, %2, from above: the disc is the find, the arrow the robot; yellow is high; lines are 1 m apart</source>
        <translation>Scan von %1, %2, von oben: die Scheibe ist der Fund, der Pfeil der Roboter; Gelb ist hoch; Linien im Abstand von 1 m</translation>
    </message>
    <message>
        <source>scan %1 of %2 at %3, %4 points</source>
        <translation>Scan %1 von %2 um %3, %4 Punkte</translation>
    </message>
    <message>
        <source>scan of %1 at %2, %3 points</source>
        <translation>Scan von %1 um %2, %3 Punkte</translation>
    </message>
    <message>
        <source>%1 stood at x %2, y %3 m, heading %4° in the map, at %5</source>
        <translation>%1 stand bei x %2, y %3 m, Richtung %4° in der Karte, um %5</translation>
    </message>
    <message>
        <source>%1 stood at x %2, y %3 m of its odometry, heading %4°, at %5: its place in the map is not known</source>
        <translation>%1 stand bei x %2, y %3 m seiner Odometrie, Richtung %4°, um %5: sein Ort in der Karte ist nicht bekannt</translation>
    </message>
    <message>
        <source>CO₂ %1 ppm at %2 (%3)</source>
        <translation>CO₂ %1 ppm um %2 (%3)</translation>
    </message>
    <message>
        <source>more pictures, in the mission: %1</source>
        <translation>weitere Bilder, in der Mission: %1</translation>
    </message>
</context>
<context>
    <name>Panes</name>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Second camera</source>
        <translation>Zweite Kamera</translation>
    </message>
    <message>
        <source>3D map</source>
        <translation>3D-Karte</translation>
    </message>
    <message>
        <source>Scans and decisions</source>
        <translation>Scans und Entscheidungen</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Übersehen</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>Virtual scan</source>
        <translation>Virtueller Scan</translation>
    </message>
    <message>
        <source>Victims</source>
        <translation>Opfer</translation>
    </message>
    <message>
        <source>Finds</source>
        <translation>Funde</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Wertung</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Funk</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Flippers and arm</source>
        <translation>Flipper und Arm</translation>
    </message>
    <message>
        <source>Topics</source>
        <translation>Topics</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Koordinatensysteme</translation>
    </message>
</context>
<context>
    <name>PdfText</name>
    <message>
        <source>page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>x is up, y is left; lines of the grid are 0.5 m apart</source>
        <translation>x zeigt nach oben, y nach links; Rasterlinien im Abstand von 0.5 m</translation>
    </message>
</context>
<context>
    <name>ReportText</name>
    <message>
        <source>confirmed</source>
        <translation>bestätigt</translation>
    </message>
    <message>
        <source>not confirmed</source>
        <translation>nicht bestätigt</translation>
    </message>
    <message>
        <source>A (autonomous)</source>
        <translation>A (autonom)</translation>
    </message>
    <message>
        <source>T (teleoperated)</source>
        <translation>T (teleoperiert)</translation>
    </message>
    <message>
        <source>Victim</source>
        <translation>Opfer</translation>
    </message>
    <message>
        <source>Hazard</source>
        <translation>Gefahr</translation>
    </message>
    <message>
        <source>QR code</source>
        <translation>QR-Code</translation>
    </message>
    <message>
        <source>Object of interest</source>
        <translation>Objekt von Interesse</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3 m</source>
        <translation>x %1, y %2, z %3 m</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>Competition</source>
        <translation>Wettbewerb</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Mission</source>
        <translation>Mission</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>%1 by the mission&apos;s clock</source>
        <translation>%1 nach der Missionsuhr</translation>
    </message>
    <message>
        <source>Operators</source>
        <translation>Operatoren</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>Stationen</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>%1 scans, %2 m² explored</source>
        <translation>%1 Scans, %2 m² erkundet</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Scans in the map</source>
        <translation>Scans in der Karte</translation>
    </message>
    <message>
        <source>Autonomous</source>
        <translation>Autonom</translation>
    </message>
    <message>
        <source>Teleoperated</source>
        <translation>Teleoperiert</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Nothing was filed.</source>
        <translation>Es wurde nichts erfasst.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Place in the map</source>
        <translation>Ort in der Karte</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>No robot drove near it: there is no way to tell.</source>
        <translation>Kein Roboter fuhr in die Nähe: ein Weg lässt sich nicht angeben.</translation>
    </message>
    <message>
        <source>%1 m from the start of %2 along the driven trail, the last %3 m straight on.</source>
        <translation>%1 m vom Start von %2 entlang der gefahrenen Spur, die letzten %3 m geradeaus.</translation>
    </message>
    <message>
        <source>%1 m from the start of %2 along the driven trail; for the last %3 m, no free straight way is known.</source>
        <translation>%1 m vom Start von %2 entlang der gefahrenen Spur; für die letzten %3 m ist kein freier gerader Weg bekannt.</translation>
    </message>
    <message>
        <source>Report of a rescue mission</source>
        <translation>Bericht einer Rettungsmission</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>%1 others were discarded or merged.</source>
        <translation>%1 weitere wurden verworfen oder vereint.</translation>
    </message>
    <message>
        <source>What was computed where</source>
        <translation>Was wo berechnet wurde</translation>
    </message>
    <message>
        <source>What is missing or doubtful</source>
        <translation>Was fehlt oder zweifelhaft ist</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>, ± %1 m</source>
        <translation>, ± %1 m</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>%1 m above the floor</source>
        <translation>%1 m über dem Boden</translation>
    </message>
    <message>
        <source>%1, %2 after the mission&apos;s begin</source>
        <translation>%1, %2 nach Beginn der Mission</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Schild</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Geräusch</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>Situation</source>
        <translation>Situation</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Belege</translation>
    </message>
    <message>
        <source>The way to %1</source>
        <translation>Der Weg zu %1</translation>
    </message>
    <message>
        <source>%1: map at %2 to %3 m above the floor</source>
        <translation>%1: Karte von %2 bis %3 m über dem Boden</translation>
    </message>
    <message>
        <source>Finds</source>
        <translation>Funde</translation>
    </message>
    <message>
        <source>Report made</source>
        <translation>Bericht erstellt</translation>
    </message>
    <message>
        <source>; storey %1: %2 m²</source>
        <translation>; Stockwerk %1: %2 m²</translation>
    </message>
    <message>
        <source>Storey</source>
        <translation>Stockwerk</translation>
    </message>
    <message>
        <source> of storey %1</source>
        <translation> von Stockwerk %1</translation>
    </message>
    <message>
        <source>%1: storey %2, map at %3 to %4 m above its floor</source>
        <translation>%1: Stockwerk %2, Karte in %3 bis %4 m über seinem Boden</translation>
    </message>
</context>
<context>
    <name>ScoreText</name>
    <message>
        <source>teleoperated</source>
        <translation>teleoperiert</translation>
    </message>
    <message>
        <source>robot drove, station or operator found</source>
        <translation>Roboter fuhr, Station oder Operator fand</translation>
    </message>
    <message>
        <source>robot drove and found by itself</source>
        <translation>Roboter fuhr und fand selbst</translation>
    </message>
    <message>
        <source>Score, estimated</source>
        <translation>Wertung, geschätzt</translation>
    </message>
    <message>
        <source>Profile %1 (%2), version %3. The quality of the map is the judges&apos; to tell; here it counts as full.</source>
        <translation>Profil %1 (%2), Version %3. Die Güte der Karte beurteilt die Jury; hier zählt sie voll.</translation>
    </message>
    <message>
        <source>Items</source>
        <translation>Posten</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Autonomy</source>
        <translation>Autonomie</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>%1 (not confirmed)</source>
        <translation>%1 (nicht bestätigt)</translation>
    </message>
    <message>
        <source>%1 of the finds, less %2 for contacts (%3 with the arena, %4 with victims), divided by %5 (operators: %6): &lt;b&gt;%7&lt;/b&gt;</source>
        <translation>%1 aus den Funden, abzüglich %2 für Berührungen (%3 der Arena, %4 von Opfern), geteilt durch %5 (Operatoren: %6): &lt;b&gt;%7&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Values of the profile for which no readable source was found: %1.</source>
        <translation>Werte des Profils, für die keine lesbare Quelle gefunden wurde: %1.</translation>
    </message>
    <message>
        <source>weights of the areas</source>
        <translation>Gewichte der Bereiche</translation>
    </message>
    <message>
        <source>points of the items</source>
        <translation>Punkte der Angaben</translation>
    </message>
    <message>
        <source>penalty of a contact with the arena</source>
        <translation>Abzug für eine Berührung der Arena</translation>
    </message>
    <message>
        <source>penalty of a contact with a victim</source>
        <translation>Abzug für eine Berührung eines Opfers</translation>
    </message>
    <message>
        <source>divisor by operators</source>
        <translation>Teiler nach Bedienern</translation>
    </message>
    <message>
        <source>points of a hazard sign</source>
        <translation>Punkte eines Gefahrzeichens</translation>
    </message>
    <message>
        <source>points of a QR code</source>
        <translation>Punkte eines QR-Codes</translation>
    </message>
    <message>
        <source>points of an object of interest</source>
        <translation>Punkte eines Objekts von Interesse</translation>
    </message>
    <message>
        <source>factor of autonomy</source>
        <translation>Faktor der Autonomie</translation>
    </message>
    <message>
        <source>factor of semi-autonomy</source>
        <translation>Faktor der Teilautonomie</translation>
    </message>
    <message>
        <source>minutes of a mission</source>
        <translation>Minuten einer Mission</translation>
    </message>
    <message>
        <source>The profile has no weight for the area “%1”: its finds count once.</source>
        <translation>Das Profil hat kein Gewicht für den Bereich „%1“: Funde dort zählen einfach.</translation>
    </message>
    <message>
        <source>storey %1: %2</source>
        <translation>Stockwerk %1: %2</translation>
    </message>
    <message>
        <source>Of the finds, by storey: %1.</source>
        <translation>Von den Funden je Stockwerk: %1.</translation>
    </message>
    <message>
        <source>Storey</source>
        <translation>Stockwerk</translation>
    </message>
</context>
<context>
    <name>WorkText</name>
    <message>
        <source>body heat</source>
        <translation>Körperwärme</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>QR codes</source>
        <translation>QR-Codes</translation>
    </message>
    <message>
        <source>hazard signs</source>
        <translation>Gefahrzeichen</translation>
    </message>
    <message>
        <source>%1 drove by itself for %2</source>
        <translation>%1 fuhr %2 lang selbst</translation>
    </message>
    <message>
        <source>no robot drove by itself</source>
        <translation>kein Roboter fuhr selbst</translation>
    </message>
    <message>
        <source>there was no map to be made</source>
        <translation>es gab keine Karte zu machen</translation>
    </message>
    <message>
        <source>this report was written</source>
        <translation>dieser Bericht wurde geschrieben</translation>
    </message>
    <message>
        <source>%1 was driven for %2</source>
        <translation>%1 wurde %2 lang gefahren</translation>
    </message>
    <message>
        <source>On the robots:</source>
        <translation>Auf den Robotern:</translation>
    </message>
    <message>
        <source>On the operator station:</source>
        <translation>Auf der Bedienstation:</translation>
    </message>
    <message>
        <source>By people:</source>
        <translation>Durch Menschen:</translation>
    </message>
    <message>
        <source>candidates that they saw by themselves: %1</source>
        <translation>Kandidaten, die sie selbst sahen: %1</translation>
    </message>
    <message>
        <source>scans registered into this map while robots drove: %1</source>
        <translation>Scans, die während der Fahrt in diese Karte registriert wurden: %1</translation>
    </message>
    <message>
        <source>scans registered into this map for this report: %1</source>
        <translation>Scans, die für diesen Bericht in diese Karte registriert wurden: %1</translation>
    </message>
    <message>
        <source>candidates reported: %1</source>
        <translation>gemeldete Kandidaten: %1</translation>
    </message>
    <message>
        <source>candidates reported: %1, by %2</source>
        <translation>gemeldete Kandidaten: %1, durch %2</translation>
    </message>
    <message>
        <source>finds filed: %1, reported by a station before: %2, confirmed: %3</source>
        <translation>erfasste Funde: %1, davon zuvor von einer Station gemeldet: %2, bestätigt: %3</translation>
    </message>
    <message>
        <source>decisions on scans and the map&apos;s area: %1</source>
        <translation>Entscheidungen über Scans und den Bereich der Karte: %1</translation>
    </message>
    <message>
        <source>tags of victims</source>
        <translation>Schilder von Opfern</translation>
    </message>
</context>
<context>
    <name>leitstand::AlarmLine</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>battery: %1 min left</source>
        <translation>Akku: noch %1 min</translation>
    </message>
    <message>
        <source>battery: %1 % left</source>
        <translation>Akku: noch %1 %</translation>
    </message>
    <message>
        <source>its clock is %1 s ahead</source>
        <translation>Uhr geht %1 s vor</translation>
    </message>
    <message>
        <source>its clock is %1 s behind</source>
        <translation>Uhr geht %1 s nach</translation>
    </message>
    <message>
        <source>tilted: %1 % of where it tips over</source>
        <translation>geneigt: %1 % der Kippgrenze</translation>
    </message>
    <message>
        <source>rolled over, tilted by %1°</source>
        <translation>umgekippt, um %1° geneigt</translation>
    </message>
    <message>
        <source>link lost, silent for %1</source>
        <translation>Funk verloren, seit %1 still</translation>
    </message>
    <message>
        <source>link: %1</source>
        <translation>Funk: %1</translation>
    </message>
    <message>
        <source>CO₂ %1 ppm</source>
        <translation>CO₂ %1 ppm</translation>
    </message>
    <message>
        <source>bumped: %1</source>
        <translation>angestoßen: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>does not answer STOP for %1</source>
        <translation>antwortet seit %1 nicht auf STOP</translation>
    </message>
    <message>
        <source>camera %1 repeats one picture for %2</source>
        <translation>Kamera %1 wiederholt seit %2 ein Bild</translation>
    </message>
    <message>
        <source>drive control was lost to %1</source>
        <translation>Fahrrecht an %1 verloren</translation>
    </message>
    <message>
        <source>uncertain scans to be decided on: %1</source>
        <translation>unsichere Scans zu entscheiden: %1</translation>
    </message>
    <message>
        <source>log: %1</source>
        <translation>Log: %1</translation>
    </message>
    <message>
        <source>over for %1</source>
        <translation>vorbei seit %1</translation>
    </message>
    <message>
        <source>muted for %1 s</source>
        <translation>stumm noch %1 s</translation>
    </message>
    <message>
        <source>not heard: %1</source>
        <translation>nicht zu hören: %1</translation>
    </message>
    <message>
        <source>wheels turned for %1 m, the map says it stands</source>
        <translation>Räder drehten sich %1 m weit, laut Karte steht er</translation>
    </message>
</context>
<context>
    <name>leitstand::AlarmListModel</name>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Act</source>
        <translation>Handeln</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source> · acknowledged</source>
        <translation> · quittiert</translation>
    </message>
</context>
<context>
    <name>leitstand::AlarmPanel</name>
    <message>
        <source>No alarms</source>
        <translation>Keine Alarme</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Alarms, newest first; Return acknowledges the chosen one</source>
        <translation>Alarme, neueste zuerst; Eingabetaste quittiert den gewählten</translation>
    </message>
    <message>
        <source>⌫ Acknowledge</source>
        <translation>⌫ Quittieren</translation>
    </message>
    <message>
        <source>Acknowledges the newest alarm that is not: its tone ends</source>
        <translation>Quittiert den neuesten offenen Alarm: sein Ton endet</translation>
    </message>
    <message>
        <source>Acknowledge the newest alarm</source>
        <translation>Neuesten Alarm quittieren</translation>
    </message>
    <message>
        <source>No tones for one minute; alarms are shown all the same</source>
        <translation>Eine Minute lang keine Töne; Alarme werden weiterhin angezeigt</translation>
    </message>
    <message>
        <source>Alarms, newest first</source>
        <translation>Alarme, neueste zuerst</translation>
    </message>
    <message>
        <source>Alarms · %1</source>
        <translation>Alarme · %1</translation>
    </message>
    <message>
        <source>M Mute</source>
        <translation>M Stumm</translation>
    </message>
    <message>
        <source>M %1</source>
        <translation>M %1</translation>
    </message>
    <message>
        <source>Mute tones for one minute</source>
        <translation>Töne eine Minute stumm schalten</translation>
    </message>
</context>
<context>
    <name>leitstand::AlarmsFeature</name>
    <message>
        <source>&amp;Acknowledge the newest alarm</source>
        <translation>Neuesten &amp;Alarm quittieren</translation>
    </message>
    <message>
        <source>Its tone ends; it stays in the list while it stands</source>
        <translation>Sein Ton endet; er bleibt in der Liste, solange er besteht</translation>
    </message>
    <message>
        <source>&amp;Mute alarms for a minute</source>
        <translation>Alarme eine Minute stu&amp;mm</translation>
    </message>
    <message>
        <source>No tones; again: tones at once</source>
        <translation>Keine Töne; noch einmal: sofort wieder Töne</translation>
    </message>
</context>
<context>
    <name>leitstand::Application</name>
    <message>
        <source>%1 was recorded until a moment ago: Mission ▸ Go on with the mission before (or leitstand --resume)</source>
        <translation>%1 wurde bis eben aufgezeichnet: Mission ▸ Vorherige Mission fortsetzen (oder leitstand --resume)</translation>
    </message>
    <message>
        <source>The map of %1 is being copied.</source>
        <translation>Die Karte von %1 wird kopiert.</translation>
    </message>
</context>
<context>
    <name>leitstand::AttitudeGauge</name>
    <message>
        <source>Attitude</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>The blue line is the horizon. Where it reaches the dots, the robot tips over.</source>
        <translation>Die blaue Linie ist der Horizont. Wo sie die Punkte erreicht, kippt der Roboter um.</translation>
    </message>
</context>
<context>
    <name>leitstand::BottomStrip</name>
    <message>
        <source>Reading %1</source>
        <translation>Liest %1</translation>
    </message>
    <message>
        <source>Reading %1 · %2 of %3</source>
        <translation>Liest %1 · %2 von %3</translation>
    </message>
    <message>
        <source>Registering %1 · %2 of %3</source>
        <translation>Registriert %1 · %2 von %3</translation>
    </message>
    <message>
        <source>▲ 1 error</source>
        <translation>▲ 1 Fehler</translation>
    </message>
    <message>
        <source>▲ %1 errors</source>
        <translation>▲ %1 Fehler</translation>
    </message>
    <message>
        <source>1 message</source>
        <translation>1 Meldung</translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation>%1 Meldungen</translation>
    </message>
    <message>
        <source>No messages</source>
        <translation>Keine Meldungen</translation>
    </message>
</context>
<context>
    <name>leitstand::BrakeSays</name>
    <message>
        <source>brake not tested</source>
        <translation>Bremse nicht geprüft</translation>
    </message>
    <message>
        <source>brake test passed: it stood after {} ms and {} cm</source>
        <translation>Bremsprüfung bestanden: er stand nach {} ms und {} cm</translation>
    </message>
    <message>
        <source>brake test passed: without commands it braked after {} ms and stood after {} ms and {} cm</source>
        <translation>Bremsprüfung bestanden: ohne Fahrbefehle bremste er nach {} ms und stand nach {} ms und {} cm</translation>
    </message>
    <message>
        <source>brake test FAILED: without commands it braked after {} ms and stood only after {} ms and {} cm</source>
        <translation>Bremsprüfung NICHT BESTANDEN: ohne Fahrbefehle bremste er nach {} ms und stand erst nach {} ms und {} cm</translation>
    </message>
    <message>
        <source>brake test FAILED: without commands it still moved after {} ms and {} cm</source>
        <translation>Bremsprüfung NICHT BESTANDEN: ohne Fahrbefehle fuhr er nach {} ms und {} cm noch</translation>
    </message>
    <message>
        <source>brake test without result: {}</source>
        <translation>Bremsprüfung ohne Ergebnis: {}</translation>
    </message>
    <message>
        <source>only {} cm are free ahead, {} cm are needed</source>
        <translation>nur {} cm sind voraus frei, {} cm werden gebraucht</translation>
    </message>
</context>
<context>
    <name>leitstand::ByHandWindow</name>
    <message>
        <source>The map is made ready to be corrected.</source>
        <translation>Die Karte wird zum Berichtigen vorbereitet.</translation>
    </message>
    <message>
        <source>The map follows what was decided. The review opens again then.</source>
        <translation>Die Karte folgt dem, was entschieden wurde. Danach öffnet sich die Auswertung neu.</translation>
    </message>
    <message>
        <source>The map is as it was left by hand</source>
        <translation>Die Karte ist so, wie sie von Hand hinterlassen wurde</translation>
    </message>
    <message>
        <source>%1 – map by hand – Leitstand</source>
        <translation>%1 – Karte von Hand – Leitstand</translation>
    </message>
    <message>
        <source>Back to the &amp;review</source>
        <translation>Zurück zur Aus&amp;wertung</translation>
    </message>
    <message>
        <source>The review opens again, on the map as it is now. What was decided here is in the mission, and can be taken back here, also later</source>
        <translation>Die Auswertung öffnet sich neu, mit der Karte, wie sie jetzt ist. Was hier entschieden wurde, steht in der Mission und lässt sich hier zurücknehmen, auch später</translation>
    </message>
    <message>
        <source>MAP BY HAND · %1</source>
        <translation>KARTE VON HAND · %1</translation>
    </message>
</context>
<context>
    <name>leitstand::CameraFeature</name>
    <message>
        <source>Re-&amp;centre cameras</source>
        <translation>Kameras &amp;zentrieren</translation>
    </message>
    <message>
        <source>All cameras of the robot look ahead</source>
        <translation>Alle Kameras des Roboters blicken nach vorn</translation>
    </message>
    <message>
        <source>Turns the large camera by 10 degrees; its keys turn it while they are held</source>
        <translation>Dreht die große Kamera um 10 Grad; ihre Tasten drehen sie, solange sie gehalten werden</translation>
    </message>
    <message>
        <source>Turn &amp;left	Q</source>
        <translation>Nach &amp;links	Q</translation>
    </message>
    <message>
        <source>Turn &amp;right	E</source>
        <translation>Nach &amp;rechts	E</translation>
    </message>
    <message>
        <source>Turn &amp;up	PgUp</source>
        <translation>Nach &amp;oben	PgUp</translation>
    </message>
    <message>
        <source>Turn &amp;down	PgDown</source>
        <translation>Nach &amp;unten	PgDown</translation>
    </message>
    <message>
        <source>&amp;Next small picture</source>
        <translation>&amp;Nächstes kleines Bild</translation>
    </message>
    <message>
        <source>Shows the next camera of the robot in the small pane</source>
        <translation>Zeigt die nächste Kamera des Roboters im kleinen Bild</translation>
    </message>
    <message>
        <source>E&amp;xchange both pictures</source>
        <translation>Bilder &amp;tauschen</translation>
    </message>
    <message>
        <source>The camera in the small pane gets the large one</source>
        <translation>Die Kamera des kleinen Bildes kommt ins große</translation>
    </message>
    <message>
        <source>More contrast in pictures: gently, strongly, not. The log keeps them as they came</source>
        <translation>Mehr Kontrast in Bildern: leicht, stark, aus. Das Log behält sie, wie sie kamen</translation>
    </message>
    <message>
        <source>Omnidirectional as &amp;panorama</source>
        <translation>Rundumbild als &amp;Panorama</translation>
    </message>
    <message>
        <source>All around in one strip, ahead in the middle; or as the mirror shows it</source>
        <translation>Rundum in einem Streifen, vorn in der Mitte; oder wie der Spiegel es zeigt</translation>
    </message>
    <message>
        <source>Keep a &amp;snapshot</source>
        <translation>&amp;Schnappschuss sichern</translation>
    </message>
    <message>
        <source>The newest large picture, as it came, into the mission&apos;s folder snapshots</source>
        <translation>Das neueste große Bild, wie es kam, in den Ordner snapshots der Mission</translation>
    </message>
    <message>
        <source>Keep a snapshot of the s&amp;mall picture</source>
        <translation>Schnappschuss vom &amp;kleinen Bild sichern</translation>
    </message>
    <message>
        <source>The same of the small picture</source>
        <translation>Dasselbe vom kleinen Bild</translation>
    </message>
    <message>
        <source>Infrared in &amp;iron colours</source>
        <translation>Infrarot in &amp;Eisenfarben</translation>
    </message>
    <message>
        <source>Infrared in grey, &amp;hot is white</source>
        <translation>Infrarot grau, heiß ist &amp;weiß</translation>
    </message>
    <message>
        <source>Infrared colours &amp;follow the picture</source>
        <translation>Infrarot&amp;farben folgen dem Bild</translation>
    </message>
    <message>
        <source>From its coldest to its hottest; otherwise a colour is always the same temperature</source>
        <translation>Von der kältesten zur heißesten Stelle; sonst steht eine Farbe immer für dieselbe Temperatur</translation>
    </message>
    <message>
        <source>There is no picture to keep yet</source>
        <translation>Es gibt noch kein Bild zum Sichern</translation>
    </message>
    <message>
        <source>no picture of %1</source>
        <translation>kein Bild von %1</translation>
    </message>
    <message>
        <source>The camera sees nothing there: nothing was filed</source>
        <translation>Dort sieht die Kamera nichts: nichts wurde erfasst</translation>
    </message>
    <message>
        <source>Help in the d&amp;ark</source>
        <translation>Hilfe im D&amp;unkeln</translation>
    </message>
    <message>
        <source>Infrared in grey, hot is &amp;black</source>
        <translation>Infrarot in Grau, heiß ist &amp;schwarz</translation>
    </message>
</context>
<context>
    <name>leitstand::CameraKeys</name>
    <message>
        <source>Q E PgUp PgDn</source>
        <translation>Q E PgUp PgDn</translation>
    </message>
</context>
<context>
    <name>leitstand::CameraPane</name>
    <message>
        <source>colours follow the picture</source>
        <translation>Farben folgen dem Bild</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>pan %1</source>
        <translation>Schwenk %1</translation>
    </message>
    <message>
        <source>pan %1 left</source>
        <translation>Schwenk %1 links</translation>
    </message>
    <message>
        <source>pan %1 right</source>
        <translation>Schwenk %1 rechts</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 unten</translation>
    </message>
    <message>
        <source>%1 up</source>
        <translation>%1 oben</translation>
    </message>
    <message>
        <source>%1 turns the cameras</source>
        <translation>%1 dreht die Kameras</translation>
    </message>
    <message>
        <source>asking for the cameras</source>
        <translation>fragt nach den Kameras</translation>
    </message>
    <message>
        <source>No camera</source>
        <translation>Keine Kamera</translation>
    </message>
    <message>
        <source>Infrared °C</source>
        <translation>Infrarot °C</translation>
    </message>
    <message>
        <source>Infrared</source>
        <translation>Infrarot</translation>
    </message>
    <message>
        <source>Left camera</source>
        <translation>Linke Kamera</translation>
    </message>
    <message>
        <source>Right camera</source>
        <translation>Rechte Kamera</translation>
    </message>
    <message>
        <source>Omnidirectional camera</source>
        <translation>Rundumkamera</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>contrast raised</source>
        <translation>Kontrast erhöht</translation>
    </message>
    <message>
        <source>contrast raised strongly</source>
        <translation>Kontrast stark erhöht</translation>
    </message>
    <message>
        <source>%1 turn</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>%1 re-centres</source>
        <translation>%1 zentriert</translation>
    </message>
    <message>
        <source>left 90°</source>
        <translation>links 90°</translation>
    </message>
    <message>
        <source>right 90°</source>
        <translation>rechts 90°</translation>
    </message>
    <message>
        <source>behind</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>The ring tells how near things are: faint is far, dots are unknown, amber near, thick red-orange at the body.
The blue line is the horizon.</source>
        <translation>Der Ring zeigt, wie nah Hindernisse sind: blass ist fern, Punkte sind unbekannt, Bernstein ist nah, dick rot-orange direkt am Roboter.
Die blaue Linie ist der Horizont.</translation>
    </message>
</context>
<context>
    <name>leitstand::ChangedModel</name>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>weg</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 m</source>
        <translation>%1 × %2 × %3 m</translation>
    </message>
    <message>
        <source>x %1, y %2</source>
        <translation>x %1, y %2</translation>
    </message>
    <message>
        <source>%1 → %2: new %3, gone %4</source>
        <translation>%1 → %2: neu %3, weg %4</translation>
    </message>
    <message>
        <source>What changed is being looked for</source>
        <translation>Was sich geändert hat, wird gesucht</translation>
    </message>
    <message>
        <source>The map is of one mission alone: there is nothing to compare it with</source>
        <translation>Die Karte stammt aus einer einzigen Mission: es gibt nichts zu vergleichen</translation>
    </message>
    <message>
        <source>Where both looked, nothing changed</source>
        <translation>Wo beide hinsahen, hat sich nichts geändert</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>In the map</source>
        <translation>In der Karte</translation>
    </message>
    <message>
        <source>The maps of the missions have not met yet: nothing can be compared</source>
        <translation>Die Karten der Missionen haben sich noch nicht getroffen: nichts kann verglichen werden</translation>
    </message>
</context>
<context>
    <name>leitstand::ChangesFeature</name>
    <message>
        <source>What c&amp;hanged</source>
        <translation>Was sich geän&amp;dert hat</translation>
    </message>
    <message>
        <source>Colours and lists what came and what went since the missions before: in a map that is put together from several</source>
        <translation>Färbt und listet, was seit den früheren Missionen hinzukam und was weg ist: in einer Karte aus mehreren Missionen</translation>
    </message>
    <message>
        <source>Show what chan&amp;ged on the map</source>
        <translation>Geändertes in der &amp;Karte zeigen</translation>
    </message>
    <message>
        <source>Moves the map to what is chosen in the list</source>
        <translation>Rückt die Karte zu dem, was in der Liste gewählt ist</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Choose something in the list of what changed</source>
        <translation>Wählen Sie etwas in der Liste des Geänderten</translation>
    </message>
</context>
<context>
    <name>leitstand::ChangesPanel</name>
    <message>
        <source>What changed</source>
        <translation>Was sich geändert hat</translation>
    </message>
    <message>
        <source>What came and what went, the largest first</source>
        <translation>Was hinzukam und was weg ist, das Größte zuerst</translation>
    </message>
</context>
<context>
    <name>leitstand::ClockFace</name>
    <message>
        <source>Mission clock</source>
        <translation>Missionsuhr</translation>
    </message>
</context>
<context>
    <name>leitstand::ClockText</name>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Mission time %1, %2</source>
        <translation>Missionszeit %1, %2</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>left</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Mission time %1 of %2, %3</source>
        <translation>Missionszeit %1 von %2, %3</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>Pause</translation>
    </message>
</context>
<context>
    <name>leitstand::ClosingQuestion</name>
    <message>
        <source>Close the station</source>
        <translation>Station schließen</translation>
    </message>
    <message>
        <source>Driving by itself: %1</source>
        <translation>Fährt selbständig: %1</translation>
    </message>
    <message>
        <source>Left driving, it goes on, and this station can stop it no more. Stopped, it stands until a station releases it. Robots that somebody drives from here stand in any case. Esc stops all robots at once.</source>
        <translation>Bleibt er in Fahrt, fährt er weiter, und diese Station kann ihn nicht mehr anhalten. Angehalten steht er, bis eine Station ihn freigibt. Roboter, die von hier gefahren werden, stehen in jedem Fall. Esc hält alle Roboter sofort an.</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Anhalten und schließen</translation>
    </message>
    <message>
        <source>Leave driving and close</source>
        <translation>Weiterfahren lassen und schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Closes as soon as they stand</source>
        <translation>Schließt, sobald sie stehen</translation>
    </message>
    <message>
        <source>No answer to the stop. Close all the same?</source>
        <translation>Keine Antwort auf den Halt. Trotzdem schließen?</translation>
    </message>
</context>
<context>
    <name>leitstand::CommandTable</name>
    <message>
        <source>&amp;Mission</source>
        <translation>&amp;Mission</translation>
    </message>
    <message>
        <source>&amp;Robot</source>
        <translation>&amp;Roboter</translation>
    </message>
    <message>
        <source>&amp;Cameras</source>
        <translation>&amp;Kameras</translation>
    </message>
    <message>
        <source>M&amp;ap</source>
        <translation>Kar&amp;te</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
</context>
<context>
    <name>leitstand::CompareFeature</name>
    <message>
        <source>&amp;Compare registrations</source>
        <translation>Registrierungen &amp;vergleichen</translation>
    </message>
    <message>
        <source>Registers the key scans with other settings and shows both maps and their figures</source>
        <translation>Registriert die Schlüsselscans mit anderen Einstellungen und zeigt beide Karten und ihre Kennzahlen</translation>
    </message>
    <message>
        <source>The mission is still read through</source>
        <translation>Die Mission wird noch durchgelesen</translation>
    </message>
</context>
<context>
    <name>leitstand::ComparePanel</name>
    <message>
        <source>Registered again and compared</source>
        <translation>Neu registriert und verglichen</translation>
    </message>
    <message>
        <source>How far the comparison is</source>
        <translation>Wie weit der Vergleich ist</translation>
    </message>
    <message>
        <source>M&amp;inimise</source>
        <translation>M&amp;inimieren</translation>
    </message>
    <message>
        <source>Pairs of points farther apart are dropped; 0.01 to 10 m. Several values are stages, each at most the one before: 1.5, 0.5</source>
        <translation>Weiter entfernte Punktpaare zählen nicht; 0,01 bis 10 m. Mehrere Werte sind Stufen, jede höchstens so groß wie die davor: 1.5, 0.5</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>all points</source>
        <translation>alle Punkte</translation>
    </message>
    <message>
        <source>Voxe&amp;ls</source>
        <translation>Voxe&amp;l</translation>
    </message>
    <message>
        <source>Edge of the grid to which scans are thinned</source>
        <translation>Kantenlänge des Gitters, auf das Scans ausgedünnt werden</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>The map pane shows the mission&apos;s own map</source>
        <translation>Die Karte zeigt die eigene Karte der Mission</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>It shows the map registered again</source>
        <translation>Sie zeigt die neu registrierte Karte</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>It shows both: the recorded one in grey, the one registered again in its colours</source>
        <translation>Sie zeigt beide: die aufgezeichnete grau, die neu registrierte in ihren Farben</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Key scans</source>
        <translation>Schlüsselscans</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Register again</source>
        <translation>Neu registrieren</translation>
    </message>
    <message>
        <source>What was compared before stays</source>
        <translation>Der vorige Vergleich bleibt</translation>
    </message>
    <message>
        <source>Registers the mission&apos;s key scans with these settings and compares; the mission stays as it is</source>
        <translation>Registriert die Schlüsselscans der Mission mit diesen Einstellungen und vergleicht; die Mission bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Registers the mission&apos;s key scans once more, with these settings, and puts both maps beside each other: how well scans meet, how far they moved, how long it took. Nothing of the mission is changed. The newest result is kept with it.</source>
        <translation>Registriert die Schlüsselscans der Mission noch einmal mit diesen Einstellungen und stellt beide Karten nebeneinander: wie gut Scans zueinander passen, wie weit sie sich bewegten, wie lange es dauerte. An der Mission wird nichts geändert. Das neueste Ergebnis bleibt bei ihr.</translation>
    </message>
    <message>
        <source>A&amp;gainst</source>
        <translation>&amp;Gegen</translation>
    </message>
    <message>
        <source>Maximum &amp;distance</source>
        <translation>Max. Ab&amp;stand</translation>
    </message>
</context>
<context>
    <name>leitstand::ComparedSummary</name>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>registered again</source>
        <translation>neu registriert</translation>
    </message>
    <message>
        <source>recorded (grey) and registered again</source>
        <translation>aufgezeichnet (grau) und neu registriert</translation>
    </message>
    <message>
        <source>3D map</source>
        <translation>3D-Karte</translation>
    </message>
    <message>
        <source>%1 key scans</source>
        <translation>%1 Schlüsselscans</translation>
    </message>
    <message>
        <source>How far key scans are from where they were recorded</source>
        <translation>Wie weit Schlüsselscans von ihrem aufgezeichneten Ort entfernt sind</translation>
    </message>
</context>
<context>
    <name>leitstand::Comparison</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1, at most %2</source>
        <comment>mean and largest</comment>
        <translation>%1, höchstens %2</translation>
    </message>
    <message>
        <source>Off the truth</source>
        <translation>Neben der Wahrheit</translation>
    </message>
    <message>
        <source>Root mean square of the robots&apos; positions at the key scans, after the map was turned and shifted to fit the recorded truth best</source>
        <translation>Quadratisches Mittel der Roboterpositionen an den Schlüsselscans, nachdem die Karte bestmöglich auf die aufgezeichnete Wahrheit gedreht und verschoben wurde</translation>
    </message>
    <message>
        <source>Turned off the truth</source>
        <translation>Gegen die Wahrheit gedreht</translation>
    </message>
    <message>
        <source>The same of their attitudes</source>
        <translation>Dasselbe für ihre Lage</translation>
    </message>
    <message>
        <source>Victims off the truth</source>
        <translation>Opfer neben der Wahrheit</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation>Wie aufgezeichnet</translation>
    </message>
    <message>
        <source>Registered again</source>
        <translation>Neu registriert</translation>
    </message>
    <message>
        <source>Key scans</source>
        <translation>Schlüsselscans</translation>
    </message>
    <message>
        <source>Those that were not set aside</source>
        <translation>Alle, die nicht beiseitegelegt sind</translation>
    </message>
    <message>
        <source>Uncertain</source>
        <translation>Unsicher</translation>
    </message>
    <message>
        <source>Scans of which the registration was not sure</source>
        <translation>Scans, bei denen die Registrierung unsicher war</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translation>Beiseite</translation>
    </message>
    <message>
        <source>Rejected or rewound by the operator; they are not registered again</source>
        <translation>Vom Operator verworfen oder zurückgespult; sie werden nicht neu registriert</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Mean over scans: root mean square distance to the key scan before, of points that have a partner within 10 cm</source>
        <translation>Mittel über die Scans: quadratisches Mittel des Abstands zum vorigen Schlüsselscan, für Punkte mit Partner innerhalb 10 cm</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Mean over scans: share of points that have such a partner</source>
        <translation>Mittel über die Scans: Anteil der Punkte mit solchem Partner</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Way of the robots from key scan to key scan</source>
        <translation>Weg der Roboter von Schlüsselscan zu Schlüsselscan</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Verschoben</translation>
    </message>
    <message>
        <source>How far scans are from where they were recorded, mean and largest</source>
        <translation>Wie weit Scans von ihrem aufgezeichneten Ort liegen, Mittel und Größtes</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>Time taken</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Of registering all scans; live, it was spread over the mission</source>
        <translation>Für die Registrierung aller Scans; live verteilte sie sich über die Mission</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>again</source>
        <comment>residual of a scan</comment>
        <translation>neu</translation>
    </message>
    <message>
        <source>again</source>
        <comment>overlap of a scan</comment>
        <translation>neu</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>uncertain again</source>
        <translation>neu unsicher</translation>
    </message>
    <message>
        <source>was uncertain</source>
        <translation>war unsicher</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>%1 key scans registered again: moved %2 at most</source>
        <translation>%1 Schlüsselscans neu registriert: höchstens %2 verschoben</translation>
    </message>
    <message>
        <source>moved %1 at most</source>
        <translation>höchstens %1 verschoben</translation>
    </message>
    <message>
        <source>Victims found</source>
        <translation>Gefundene Opfer</translation>
    </message>
    <message>
        <source>True victims that were filed, each find counting for one; missed: those that were not; false: finds within %1 m of no victim, or of one that was filed already</source>
        <translation>Wahre Opfer, die erfasst wurden, jedes für einen Fund; verfehlt: die übrigen; falsch: Funde ohne Opfer in %1 m Umkreis oder von einem schon erfassten</translation>
    </message>
    <message>
        <source>%1, missed %2, false %3</source>
        <comment>victims found</comment>
        <translation>%1, verfehlt %2, falsch %3</translation>
    </message>
    <message>
        <source>From each victim that was found to where it truly is, seen from above</source>
        <translation>Von jedem gefundenen Opfer zu seinem wahren Ort, von oben gesehen</translation>
    </message>
</context>
<context>
    <name>leitstand::Coverage</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Infrared</source>
        <translation>Infrarot</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>Scanner</translation>
    </message>
</context>
<context>
    <name>leitstand::CoverageFeature</name>
    <message>
        <source>Searched floor: &amp;hidden</source>
        <translation>Abgesuchter Boden: &amp;verborgen</translation>
    </message>
    <message>
        <source>The map as it is</source>
        <translation>Die Karte, wie sie ist</translation>
    </message>
    <message>
        <source>Searched by s&amp;canner</source>
        <translation>Abgesucht mit S&amp;canner</translation>
    </message>
    <message>
        <source>Tints the floor where a body would have enough points, hatches what was missed</source>
        <translation>Färbt den Boden, wo ein Körper genug Punkte hätte, schraffiert das Übersehene</translation>
    </message>
    <message>
        <source>Searched by came&amp;ra</source>
        <translation>Abgesucht mit Kame&amp;ra</translation>
    </message>
    <message>
        <source>Tints the floor where a body would span enough pixels of a camera, hatches what was missed</source>
        <translation>Färbt den Boden, wo ein Körper genug Pixel einer Kamera hätte, schraffiert das Übersehene</translation>
    </message>
    <message>
        <source>Searched by i&amp;nfrared</source>
        <translation>Abgesucht mit I&amp;nfrarot</translation>
    </message>
    <message>
        <source>Tints the floor where a body would span enough pixels of an infrared camera, hatches what was missed</source>
        <translation>Färbt den Boden, wo ein Körper genug Pixel einer Infrarotkamera hätte, schraffiert das Übersehene</translation>
    </message>
    <message>
        <source>Searched floor: ne&amp;xt sensor</source>
        <translation>Abgesuchter Boden: &amp;nächster Sensor</translation>
    </message>
    <message>
        <source>Scanner, camera, infrared, hidden</source>
        <translation>Scanner, Kamera, Infrarot, verborgen</translation>
    </message>
    <message>
        <source>&amp;What did I miss?</source>
        <translation>&amp;Was habe ich übersehen?</translation>
    </message>
    <message>
        <source>Lists the floor that robots can reach and that was not seen, the largest piece first</source>
        <translation>Listet erreichbaren Boden, der nicht gesehen wurde, das größte Stück zuerst</translation>
    </message>
    <message>
        <source>Go to what was &amp;missed</source>
        <translation>Zum Übersehenen &amp;fahren</translation>
    </message>
    <message>
        <source>Sends the selected robot to the chosen place</source>
        <translation>Schickt den gewählten Roboter an den gewählten Ort</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Hinfahren</translation>
    </message>
    <message>
        <source>Show what was missed on the ma&amp;p</source>
        <translation>Übersehenes auf der Karte &amp;zeigen</translation>
    </message>
    <message>
        <source>Moves the map to the chosen place</source>
        <translation>Rückt die Karte an den gewählten Ort</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Choose a place in the list of what was missed</source>
        <translation>Einen Ort in der Liste des Übersehenen wählen</translation>
    </message>
</context>
<context>
    <name>leitstand::DecisionText</name>
    <message>
        <source>scan %1 accepted</source>
        <translation>Scan %1 angenommen</translation>
    </message>
    <message>
        <source>%1 scans accepted</source>
        <translation>%1 Scans angenommen</translation>
    </message>
    <message>
        <source>scan %1 set aside</source>
        <translation>Scan %1 ausgeschlossen</translation>
    </message>
    <message>
        <source>%1 scans set aside</source>
        <translation>%1 Scans ausgeschlossen</translation>
    </message>
    <message>
        <source>scan %1 tried again</source>
        <translation>Scan %1 erneut versucht</translation>
    </message>
    <message>
        <source>%1 scans tried again</source>
        <translation>%1 Scans erneut versucht</translation>
    </message>
    <message>
        <source>what belongs into the map</source>
        <translation>was in die Karte gehört</translation>
    </message>
    <message>
        <source>%1 as corrected in a review</source>
        <comment>V1</comment>
        <translation>%1, wie in einer Auswertung berichtigt</translation>
    </message>
    <message>
        <source>a note of a review</source>
        <translation>eine Notiz einer Auswertung</translation>
    </message>
    <message>
        <source>a closed loop</source>
        <translation>eine geschlossene Schleife</translation>
    </message>
    <message>
        <source>two places kept apart</source>
        <translation>eine Stelle, die von einer anderen unterschieden wurde</translation>
    </message>
    <message>
        <source>the tidied map</source>
        <translation>die aufgeräumte Karte</translation>
    </message>
</context>
<context>
    <name>leitstand::DecisionsFeature</name>
    <message>
        <source>Ne&amp;xt doubtful scan</source>
        <translation>Nächster z&amp;weifelhafter Scan</translation>
    </message>
    <message>
        <source>Goes to the newest scan that waits for a decision, then to older ones</source>
        <translation>Geht zum neuesten Scan, der auf eine Entscheidung wartet, dann zu älteren</translation>
    </message>
    <message>
        <source>&amp;Accept scan</source>
        <translation>Scan &amp;annehmen</translation>
    </message>
    <message>
        <source>The chosen scan counts where it stands</source>
        <translation>Der gewählte Scan gilt dort, wo er steht</translation>
    </message>
    <message>
        <source>Re&amp;ject scan</source>
        <translation>Scan a&amp;blehnen</translation>
    </message>
    <message>
        <source>The chosen scan is set aside: neither shown nor used</source>
        <translation>Der gewählte Scan wird ausgeschlossen: weder gezeigt noch verwendet</translation>
    </message>
    <message>
        <source>Re&amp;try scan</source>
        <translation>Scan &amp;erneut versuchen</translation>
    </message>
    <message>
        <source>Registers the chosen scan again, with the search chosen below</source>
        <translation>Registriert den gewählten Scan noch einmal, mit der unten gewählten Suche</translation>
    </message>
    <message>
        <source>Retry from a &amp;pose</source>
        <translation>Erneut ab &amp;Pose</translation>
    </message>
    <message>
        <source>Click on the map where the robot was, drag its heading: the chosen scan is registered again from there</source>
        <translation>Auf der Karte anklicken, wo der Roboter war, Richtung ziehen: der gewählte Scan wird von dort erneut registriert</translation>
    </message>
    <message>
        <source>Re&amp;wind to here</source>
        <translation>Bis &amp;hierher zurück</translation>
    </message>
    <message>
        <source>Sets aside all scans that entered after the chosen one</source>
        <translation>Schließt alle Scans aus, die nach dem gewählten hinzukamen</translation>
    </message>
    <message>
        <source>&amp;Undo decision</source>
        <translation>Entscheidung &amp;rückgängig</translation>
    </message>
    <message>
        <source>There is no such decision on the map</source>
        <translation>Es gibt keine solche Entscheidung auf der Karte</translation>
    </message>
    <message>
        <source>Redo decision</source>
        <translation>Entscheidung wiederholen</translation>
    </message>
    <message>
        <source>Next ?</source>
        <translation>Nächster ?</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Ablehnen</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Erneut</translation>
    </message>
    <message>
        <source>From pose</source>
        <translation>Ab Pose</translation>
    </message>
    <message>
        <source>Rewind</source>
        <translation>Bis hier</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wieder</translation>
    </message>
    <message>
        <source>Draw map&apos;s a&amp;rea</source>
        <translation>Karten&amp;umriss zeichnen</translation>
    </message>
    <message>
        <source>Click the corners of what belongs into the map, a double click ends: points of coming scans outside of it stay out</source>
        <translation>Die Ecken dessen anklicken, was in die Karte gehört, Doppelklick beendet: Punkte künftiger Scans außerhalb bleiben draußen</translation>
    </message>
    <message>
        <source>Map e&amp;verything</source>
        <translation>A&amp;lles kartieren</translation>
    </message>
    <message>
        <source>Nothing is outside of the map&apos;s area any more</source>
        <translation>Nichts liegt mehr außerhalb des Kartenumrisses</translation>
    </message>
    <message>
        <source>Draw area</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>No scan waits for a decision</source>
        <translation>Kein Scan wartet auf eine Entscheidung</translation>
    </message>
    <message>
        <source>Click where the robot was at scan %1, drag its heading · right button: not at all</source>
        <translation>Anklicken, wo der Roboter bei Scan %1 war, Richtung ziehen · rechte Taste: abbrechen</translation>
    </message>
    <message>
        <source>Click the corners of what belongs into the map, double click the last one · right button: takes a corner back</source>
        <translation>Ecken dessen anklicken, was in die Karte gehört, die letzte doppelt · rechte Taste: nimmt eine Ecke zurück</translation>
    </message>
    <message>
        <source>Takes back: %1</source>
        <translation>Nimmt zurück: %1</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>Decides again: %1</source>
        <translation>Entscheidet wieder: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>The whole world belongs into the map</source>
        <translation>Die ganze Welt gehört in die Karte</translation>
    </message>
    <message>
        <source>What is outside the dashed line stays out of the map</source>
        <translation>Was außerhalb der gestrichelten Linie liegt, bleibt aus der Karte</translation>
    </message>
    <message>
        <source>Show a place that it &amp;meets</source>
        <translation>Stelle &amp;zeigen, die er trifft</translation>
    </message>
    <message>
        <source>Click on the map where the robot was at the chosen scan by an older part of the map, drag its heading: where it fits there, the map asks whether it is the same place</source>
        <translation>In die Karte klicken, wo der Roboter beim gewählten Scan nach einem älteren Teil der Karte war, die Richtung ziehen: Wo er dort passt, fragt die Karte, ob es dieselbe Stelle ist</translation>
    </message>
    <message>
        <source>Meets…</source>
        <translation>Trifft…</translation>
    </message>
    <message>
        <source>Click where the older part of the map has the place of scan %1, drag the robot&apos;s heading · right button: not at all</source>
        <translation>Klicken, wo der ältere Teil der Karte die Stelle von Scan %1 hat, die Richtung des Roboters ziehen · rechte Taste: gar nicht</translation>
    </message>
</context>
<context>
    <name>leitstand::DecisionsPanel</name>
    <message>
        <source>Nothing above</source>
        <translation>Nichts über</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Scans and decisions</source>
        <translation>Scans und Entscheidungen</translation>
    </message>
    <message>
        <source>Key scans of the map, newest first</source>
        <translation>Schlüsselscans der Karte, neueste zuerst</translation>
    </message>
    <message>
        <source>Retry with</source>
        <translation>Erneut mit</translation>
    </message>
    <message>
        <source>How far a retry searches</source>
        <translation>Wie weit ein neuer Versuch sucht</translation>
    </message>
    <message>
        <source>How far points may be from the map at first: wide finds a scan that is far off, narrow does not mistake one wall for another</source>
        <translation>Wie weit Punkte anfangs von der Karte entfernt sein dürfen: weit findet einen Scan, der weit daneben liegt, eng verwechselt nicht eine Wand mit einer anderen</translation>
    </message>
    <message>
        <source>wide search, 1.5 m</source>
        <translation>weite Suche, 1,5 m</translation>
    </message>
    <message>
        <source>widest search, 3 m</source>
        <translation>weiteste Suche, 3 m</translation>
    </message>
    <message>
        <source>usual search, 0.5 m</source>
        <translation>übliche Suche, 0.5 m</translation>
    </message>
    <message>
        <source>narrow search, 0.25 m</source>
        <translation>enge Suche, 0.25 m</translation>
    </message>
    <message>
        <source>Points above this height, in the map&apos;s frame, are left out of the map: spectators, lamps, the hall&apos;s roof</source>
        <translation>Punkte über dieser Höhe, im Koordinatensystem der Karte, werden aus der Karte gelassen: Zuschauer, Lampen, Hallendach</translation>
    </message>
    <message>
        <source>Height above which nothing enters the map</source>
        <translation>Höhe, über der nichts in die Karte kommt</translation>
    </message>
    <message>
        <source>Choose a scan, or go to the newest doubtful one</source>
        <translation>Einen Scan wählen oder zum neuesten zweifelhaften gehen</translation>
    </message>
</context>
<context>
    <name>leitstand::DemoRobots</name>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 lässt sich nicht starten: %2</translation>
    </message>
    <message>
        <source>The simulated %1 has ended (%2): %3</source>
        <translation>Der simulierte %1 wurde beendet (%2): %3</translation>
    </message>
</context>
<context>
    <name>leitstand::DriveFeature</name>
    <message>
        <source>The keys do not drive: %1 lets them</source>
        <translation>Die Tasten fahren nicht: %1 lässt sie fahren</translation>
    </message>
    <message>
        <source>&amp;Drive with keys</source>
        <translation>Mit &amp;Tasten fahren</translation>
    </message>
    <message>
        <source>W S A D or the arrows drive the selected robot; Shift slow, Ctrl fast, Space halts, G held drives without eyes</source>
        <translation>W S A D oder Pfeiltasten fahren den gewählten Roboter; Umschalt langsam, Strg schnell, Leertaste hält an, G gehalten fährt ohne Sicht</translation>
    </message>
</context>
<context>
    <name>leitstand::DriveState</name>
    <message>
        <source>stop %1 · %2</source>
        <translation>STOP %1 · %2</translation>
    </message>
    <message>
        <source>takes no drive commands</source>
        <translation>nimmt keine Fahrbefehle an</translation>
    </message>
    <message>
        <source>does not hear drive commands</source>
        <translation>hört keine Fahrbefehle</translation>
    </message>
    <message>
        <source>the sticks are not on this robot</source>
        <translation>Steuerung nicht auf diesem Roboter</translation>
    </message>
    <message>
        <source>sticks must be neutral first</source>
        <translation>erst Sticks loslassen</translation>
    </message>
    <message>
        <source>you drive</source>
        <translation>Steuerung aktiv</translation>
    </message>
    <message>
        <source>ready: you have the sticks</source>
        <translation>bereit: Steuerung liegt hier</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>chains %1 · %2 m/s</source>
        <translation>Ketten %1 · %2 m/s</translation>
    </message>
    <message>
        <source>the chains do not follow</source>
        <translation>die Ketten folgen nicht</translation>
    </message>
    <message>
        <source>the left chain does not follow</source>
        <translation>die linke Kette folgt nicht</translation>
    </message>
    <message>
        <source>the right chain does not follow</source>
        <translation>die rechte Kette folgt nicht</translation>
    </message>
    <message>
        <source>tips at %1</source>
        <translation>kippt bei %1</translation>
    </message>
    <message>
        <source>tips at %1 · %2</source>
        <translation>kippt bei %1 · %2</translation>
    </message>
    <message>
        <source>no attitude</source>
        <translation>keine Lage</translation>
    </message>
    <message>
        <source>roll %1 · pitch %2</source>
        <translation>Rollen %1 · Nicken %2</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>charging</source>
        <translation>lädt</translation>
    </message>
    <message>
        <source>ppm</source>
        <translation>ppm</translation>
    </message>
    <message>
        <source>not fitted</source>
        <translation>nicht verbaut</translation>
    </message>
    <message>
        <source>last 2 min · alarm at %1</source>
        <translation>letzte 2 min · Alarm ab %1</translation>
    </message>
    <message>
        <source>no data yet</source>
        <translation>noch keine Daten</translation>
    </message>
    <message>
        <source>%1 requests drive control</source>
        <translation>%1 fordert das Fahrrecht an</translation>
    </message>
    <message>
        <source>drive control: yours</source>
        <translation>Fahrrecht: hier</translation>
    </message>
    <message>
        <source>%1 keeps it</source>
        <translation>%1 behält es</translation>
    </message>
    <message>
        <source>requested: listens for others</source>
        <translation>angefordert: horcht auf andere</translation>
    </message>
    <message>
        <source>requested: waits for %1</source>
        <translation>angefordert: wartet auf %1</translation>
    </message>
    <message>
        <source>%1 took over</source>
        <translation>%1 hat übernommen</translation>
    </message>
    <message>
        <source>drive control: free</source>
        <translation>Fahrrecht frei</translation>
    </message>
    <message>
        <source>%1 has it, but is silent</source>
        <translation>%1 hat es, ist aber still</translation>
    </message>
    <message>
        <source>%1 drives</source>
        <translation>%1 fährt</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 at this load</source>
        <translation>%1 bei dieser Last</translation>
    </message>
    <message>
        <source>%1 · %2 m/s</source>
        <translation>%1 · %2 m/s</translation>
    </message>
    <message>
        <source>standing · hold the button of robot %1 for 1 s to release</source>
        <translation>steht · zur Freigabe Knopf von Roboter %1 1 s gedrückt halten</translation>
    </message>
</context>
<context>
    <name>leitstand::EnergyCell</name>
    <message>
        <source>Battery and link</source>
        <translation>Akku und Funk</translation>
    </message>
    <message>
        <source>Battery %1 %2, %3
Link: %4 %5</source>
        <translation>Akku %1 %2, %3
Funk: %4 %5</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Funk</translation>
    </message>
</context>
<context>
    <name>leitstand::Error</name>
    <message>
        <source>{}: cannot be started: {}</source>
        <translation>{}: lässt sich nicht starten: {}</translation>
    </message>
    <message>
        <source>leitstand-guard has ended</source>
        <translation>leitstand-guard ist beendet</translation>
    </message>
    <message>
        <source>{}: is of other key scans than the mission has now; register again</source>
        <translation>{}: ist von anderen Schlüsselscans, als die Mission jetzt hat; bitte erneut registrieren</translation>
    </message>
    <message>
        <source>{}: expected the name of a layout ({})</source>
        <translation>{}: erwartet wurde der Name eines Layouts ({})</translation>
    </message>
    <message>
        <source>&quot;{}&quot;: expected a name of letters, digits, _ and -</source>
        <translation>&quot;{}&quot;: erwartet wurde ein Name aus Buchstaben, Ziffern, _ und -</translation>
    </message>
    <message>
        <source>{}: expected a layout of one&apos;s own</source>
        <translation>{}: erwartet wurde ein eigenes Layout</translation>
    </message>
    <message>
        <source>{}: cannot be written: {}</source>
        <translation>{}: kann nicht geschrieben werden: {}</translation>
    </message>
    <message>
        <source>{}: is no picture that can be printed</source>
        <translation>{}: ist kein Bild, das gedruckt werden kann</translation>
    </message>
    <message>
        <source>{}: expected a label for each point</source>
        <translation>{}: erwartet wurde eine Klasse für jeden Punkt</translation>
    </message>
    <message>
        <source>{}: cannot be opened</source>
        <translation>{}: kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>{}: expected %PDF at its beginning</source>
        <translation>{}: erwartet wurde %PDF am Anfang</translation>
    </message>
    <message>
        <source>{}: expected its table of objects at the end</source>
        <translation>{}: erwartet wurde die Objekttabelle am Ende</translation>
    </message>
    <message>
        <source>{}: its table of objects is not where it says</source>
        <translation>{}: die Objekttabelle ist nicht, wo die Datei es angibt</translation>
    </message>
    <message>
        <source>{}: is no file of a report</source>
        <translation>{}: ist keine Datei eines Berichts</translation>
    </message>
    <message>
        <source>{}: no report: {}</source>
        <translation>{}: kein Bericht: {}</translation>
    </message>
    <message>
        <source>event {} is not in the log</source>
        <translation>Ereignis {} ist nicht im Protokoll</translation>
    </message>
    <message>
        <source>event {} ({}) cannot be read</source>
        <translation>Ereignis {} ({}) ist nicht lesbar</translation>
    </message>
    <message>
        <source>another station has it in its log</source>
        <translation>eine andere Station hat es in ihrem Protokoll</translation>
    </message>
    <message>
        <source>{}: the report was cancelled</source>
        <translation>{}: der Bericht wurde abgebrochen</translation>
    </message>
    <message>
        <source>{}: cannot be made: {}</source>
        <translation>{}: kann nicht angelegt werden: {}</translation>
    </message>
    <message>
        <source>{}: there is nothing in it</source>
        <translation>{}: ist leer</translation>
    </message>
    <message>
        <source>{}: {} of {} scans have no odometry within half a second of their stamp</source>
        <translation>{}: {} von {} Scans haben keine Odometrie innerhalb einer halben Sekunde um ihren Zeitstempel</translation>
    </message>
    <message>
        <source>{}: nobody tells where frame &quot;{}&quot; sits (neither tf_static nor the robot&apos;s file); taken as {}</source>
        <translation>{}: niemand sagt, wo Frame &quot;{}&quot; sitzt (weder tf_static noch die Datei des Roboters); angenommen wird {}</translation>
    </message>
    <message>
        <source>{}: its file names no {} stream</source>
        <translation>{}: seine Datei nennt keinen Strom {}</translation>
    </message>
    <message>
        <source>{}: the folder could not be made: {}</source>
        <translation>{}: der Ordner konnte nicht angelegt werden: {}</translation>
    </message>
    <message>
        <source>The gamepad {} cannot be used: {}</source>
        <translation>Gamepad {} ist nicht benutzbar: {}</translation>
    </message>
    <message>
        <source>Gamepads cannot be used: {}</source>
        <translation>Gamepads sind nicht benutzbar: {}</translation>
    </message>
    <message>
        <source>{}: is missing or cannot be read; the files were asked instead</source>
        <translation>{}: fehlt oder ist nicht lesbar; stattdessen wurden die Dateien befragt</translation>
    </message>
    <message>
        <source>{}: expected at most {} bytes, found {}</source>
        <translation>{}: erwartet wurden höchstens {} Bytes, gefunden {}</translation>
    </message>
    <message>
        <source>{}: cannot be opened: {}</source>
        <translation>{}: kann nicht geöffnet werden: {}</translation>
    </message>
    <message>
        <source>{}: expected a bag&apos;s folder or file, found nothing</source>
        <translation>{}: erwartet wurde der Ordner oder die Datei eines Bags, dort ist nichts</translation>
    </message>
    <message>
        <source>{}: expected a folder or a regular file</source>
        <translation>{}: erwartet wurde ein Ordner oder eine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>{}: expected it, since metadata.yaml lists it, found nothing</source>
        <translation>{}: wird erwartet, da metadata.yaml es nennt, und fehlt</translation>
    </message>
    <message>
        <source>{}: table messages: is damaged</source>
        <translation>{}: Tabelle messages ist beschädigt</translation>
    </message>
    <message>
        <source>{}: cannot be read on while it is written</source>
        <translation>{}: kann nicht weiter gelesen werden, während sie geschrieben wird</translation>
    </message>
    <message>
        <source>{}: messages of topic number {}: expected it in the table topics</source>
        <translation>{}: Nachrichten von Topic Nummer {}: sie fehlt in der Tabelle topics</translation>
    </message>
    <message>
        <source>{}: topic {}: expected serialization &quot;cdr&quot;, found &quot;{}&quot;</source>
        <translation>{}: Topic {}: erwartet wurde Serialisierung &quot;cdr&quot;, gefunden &quot;{}&quot;</translation>
    </message>
    <message>
        <source>{}; and no page of it holds messages, either</source>
        <translation>{}; auch enthält keine Seite davon Nachrichten</translation>
    </message>
    <message>
        <source>{}; read page by page: {} messages found</source>
        <translation>{}; Seite für Seite gelesen: {} Nachrichten gefunden</translation>
    </message>
    <message>
        <source>{}: messages {} to {}: expected in a page of the table messages, found nowhere (or never written)</source>
        <translation>{}: Nachrichten {} bis {}: erwartet in einer Seite der Tabelle messages, nirgends gefunden (oder nie geschrieben)</translation>
    </message>
    <message>
        <source>{}: and further gaps</source>
        <translation>{}: und weitere Lücken</translation>
    </message>
    <message>
        <source>expected an SQLite database</source>
        <translation>erwartet wurde eine SQLite-Datenbank</translation>
    </message>
    <message>
        <source>{}: expected the tables topics and messages of a rosbag2 bag</source>
        <translation>{}: erwartet wurden die Tabellen topics und messages eines rosbag2-Bags</translation>
    </message>
    <message>
        <source>table {}</source>
        <translation>Tabelle {}</translation>
    </message>
    <message>
        <source>{}: table messages: expected ids from 1 to {}, found {} to {}</source>
        <translation>{}: Tabelle messages: erwartet wurden Nummern von 1 bis {}, gefunden {} bis {}</translation>
    </message>
    <message>
        <source>{}: expected a robot&apos;s file, found none</source>
        <translation>{}: erwartet wurde die Datei eines Roboters, gefunden wurde keine</translation>
    </message>
    <message>
        <source>{}: expected a robot&apos;s file, or the name {}, found none{}</source>
        <translation>{}: erwartet wurde die Datei eines Roboters oder der Name {}, gefunden wurde keine{}</translation>
    </message>
    <message>
        <source>picture: expected 1 to {} pixels a side and at most {}, found {} x {}</source>
        <translation>Bild: erwartet wurden 1 bis {} Pixel je Seite und höchstens {}, gefunden {} x {}</translation>
    </message>
    <message>
        <source>picture: encoding &quot;{}&quot; cannot be shown</source>
        <translation>Bild: Kodierung &quot;{}&quot; kann nicht gezeigt werden</translation>
    </message>
    <message>
        <source>picture: expected {} rows of at least {} bytes, found {} bytes, {} a row</source>
        <translation>Bild: erwartet wurden {} Zeilen von mindestens {} Bytes, gefunden {} Bytes, {} je Zeile</translation>
    </message>
    <message>
        <source>picture: expected at least 3 x 3 pixels of a Bayer pattern</source>
        <translation>Bild: erwartet wurden mindestens 3 x 3 Pixel eines Bayer-Musters</translation>
    </message>
    <message>
        <source>picture: expected pairs of pixels in a row, found {}</source>
        <translation>Bild: erwartet wurden Pixelpaare je Zeile, gefunden {}</translation>
    </message>
    <message>
        <source>picture: {}</source>
        <translation>Bild: {}</translation>
    </message>
    <message>
        <source>picture: expected a file of less than 2 GB</source>
        <translation>Bild: erwartet wurde eine Datei von weniger als 2 GB</translation>
    </message>
    <message>
        <source>picture: the file of {} bytes is damaged</source>
        <translation>Bild: die Datei von {} Bytes ist beschädigt</translation>
    </message>
    <message>
        <source>picture: {} channels cannot be shown</source>
        <translation>Bild: {} Kanäle können nicht gezeigt werden</translation>
    </message>
    <message>
        <source>thermal picture: its colours are mapped and tell no temperature</source>
        <translation>Wärmebild: seine Farben sind eingefärbt und sagen keine Temperatur</translation>
    </message>
    <message>
        <source>thermal picture: expected one number a pixel, found colours</source>
        <translation>Wärmebild: erwartet wurde eine Zahl je Pixel, gefunden Farben</translation>
    </message>
    <message>
        <source>picture: expected pixels to write, found none</source>
        <translation>Bild: erwartet wurden Pixel zum Schreiben, gefunden keine</translation>
    </message>
    <message>
        <source>picture: expected 8 or 16 bits a value, found 32, which PNG does not have</source>
        <translation>Bild: erwartet wurden 8 oder 16 Bit je Wert, gefunden 32, die PNG nicht kennt</translation>
    </message>
    <message>
        <source>picture: it could not be encoded as PNG</source>
        <translation>Bild: es konnte nicht als PNG kodiert werden</translation>
    </message>
    <message>
        <source>release: this station does not hold the grant to drive</source>
        <translation>Freigabe: diese Station hat das Fahrrecht nicht</translation>
    </message>
    <message>
        <source>release: the robot has not reported its stop yet</source>
        <translation>Freigabe: der Roboter hat seinen Halt noch nicht gemeldet</translation>
    </message>
    <message>
        <source>release: the robot has not acknowledged the stop yet</source>
        <translation>Freigabe: der Roboter hat den Halt noch nicht bestätigt</translation>
    </message>
    <message>
        <source>{}: expected a map of rosbag2&apos;s metadata</source>
        <translation>{}: erwartet wurden Metadaten von rosbag2</translation>
    </message>
    <message>
        <source>{}: expected {} with a storage_identifier</source>
        <translation>{}: erwartet wurde {} mit storage_identifier</translation>
    </message>
    <message>
        <source>{}: expected rosbag2&apos;s metadata: {}</source>
        <translation>{}: erwartet wurden Metadaten von rosbag2: {}</translation>
    </message>
    <message>
        <source>{}: message {} on page {}: expected {} bytes, found fewer</source>
        <translation>{}: Nachricht {} auf Seite {}: erwartet wurden {} Bytes, da sind weniger</translation>
    </message>
    <message>
        <source>{}: table {}</source>
        <translation>{}: Tabelle {}</translation>
    </message>
    <message>
        <source>{}: expected {} entries, found {}</source>
        <translation>{}: erwartet wurden {} Einträge, gefunden {}</translation>
    </message>
    <message>
        <source>{}: expected {} x {} pixels, found {} x {}</source>
        <translation>{}: erwartet wurden {} x {} Pixel, gefunden {} x {}</translation>
    </message>
    <message>
        <source>{}: expected its corner at x {:g}, y {:g} m with pixels of {:g} m, found x {:g}, y {:g} m with {:g} m</source>
        <translation>{}: erwartet wurde die Ecke bei x {:g}, y {:g} m mit Pixeln von {:g} m, gefunden x {:g}, y {:g} m mit {:g} m</translation>
    </message>
    <message>
        <source>{}: expected at least {} pages, found {}</source>
        <translation>{}: erwartet mindestens {} Seiten, gefunden {}</translation>
    </message>
    <message>
        <source>{}: cannot be written: it is not a regular file</source>
        <translation>{}: lässt sich nicht schreiben: keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>expected either a button or an axis, found both</source>
        <translation>erwartet wurde entweder button oder axis, gefunden beides</translation>
    </message>
    <message>
        <source>expected either a button or an axis, found neither</source>
        <translation>erwartet wurde entweder button oder axis, gefunden keines von beiden</translation>
    </message>
    <message>
        <source>expected -1 or 1, the end to which the axis is pushed from its rest</source>
        <translation>erwartet wurde -1 oder 1, das Ende, zu dem die Achse aus ihrer Ruhelage geht</translation>
    </message>
    <message>
        <source>expected at most {} commands, found {}</source>
        <translation>erwartet wurden höchstens {} Befehle, gefunden {}</translation>
    </message>
    <message>
        <source>expected the command that the control does, found nothing</source>
        <translation>erwartet wurde der Befehl des Bedienelements, gefunden nichts</translation>
    </message>
    <message>
        <source>expected a command such as camera.recentre, found {}</source>
        <translation>erwartet wurde ein Befehl wie camera.recentre, gefunden {}</translation>
    </message>
    <message>
        <source>{}: cannot be read</source>
        <translation>{}: lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>{}: its SHA-256 is not as {} says</source>
        <translation>{}: seine SHA-256 ist nicht die in {}</translation>
    </message>
    <message>
        <source>{}: is not written: the position of {} is no number</source>
        <translation>{}: wird nicht geschrieben: der Ort von {} ist keine Zahl</translation>
    </message>
    <message>
        <source>{}: cannot be written: expected a picture of RGB</source>
        <translation>{}: lässt sich nicht schreiben: erwartet ein RGB-Bild</translation>
    </message>
    <message>
        <source>expected at most {:.0f} pixels, found {} x {}</source>
        <translation>erwartet höchstens {:.0f} Pixel, gefunden {} x {}</translation>
    </message>
    <message>
        <source>expected three bands of 8 bits (24-bit RGB)</source>
        <translation>erwartet drei Kanäle von 8 Bit (24-Bit-RGB)</translation>
    </message>
    <message>
        <source>expected a georeference</source>
        <translation>erwartet eine Georeferenz</translation>
    </message>
    <message>
        <source>expected square pixels, north up (a negative y pixel size)</source>
        <translation>erwartet quadratische Pixel, Norden oben (negative Pixelgröße in y)</translation>
    </message>
    <message>
        <source>{}: is not written: the map is too far from its origin for an OctoMap</source>
        <translation>{}: wird nicht geschrieben: für eine OctoMap ist die Karte zu weit von ihrem Ursprung</translation>
    </message>
    <message>
        <source>{}: cannot be written as an OctoMap</source>
        <translation>{}: lässt sich nicht als OctoMap schreiben</translation>
    </message>
    <message>
        <source>{}: expected &quot;# Octomap OcTree binary file&quot; in its first line</source>
        <translation>{}: erwartet &quot;# Octomap OcTree binary file&quot; in der ersten Zeile</translation>
    </message>
    <message>
        <source>{}: cannot be read as an OctoMap: expected a whole tree</source>
        <translation>{}: lässt sich nicht als OctoMap lesen: erwartet ein vollständiger Baum</translation>
    </message>
    <message>
        <source>{}: cannot be read as an OctoMap: {}</source>
        <translation>{}: lässt sich nicht als OctoMap lesen: {}</translation>
    </message>
    <message>
        <source>{}: is not written: a figure of {} is no number</source>
        <translation>{}: wird nicht geschrieben: ein Wert von {} ist keine Zahl</translation>
    </message>
    <message>
        <source>expected a name as in topics (letters, digits and _, not leitstand), found {}</source>
        <translation>erwartet wurde ein Name wie in Topics (Buchstaben, Ziffern und _, nicht leitstand), gefunden {}</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>expected one capital letter, found {}</source>
        <translation>erwartet wurde ein Großbuchstabe, gefunden {}</translation>
    </message>
    <message>
        <source>expected a frame such as base_link, without a slash before it and without blanks, found {}</source>
        <translation>erwartet wurde ein Frame wie base_link, ohne Schrägstrich davor und ohne Leerzeichen, gefunden {}</translation>
    </message>
    <message>
        <source>expected a list of corners, found {}</source>
        <translation>erwartet wurde eine Liste von Ecken, gefunden {}</translation>
    </message>
    <message>
        <source>expected [x, y], each from {} to {} m, found {}</source>
        <translation>erwartet wurde [x, y], jeweils von {} bis {} m, gefunden {}</translation>
    </message>
    <message>
        <source>expected a key or pad control of its own, found {}, which is that of {}</source>
        <translation>erwartet wurde eine eigene Taste oder ein eigenes Bedienelement des Gamepads, gefunden {}; das gehört zu {}</translation>
    </message>
    <message>
        <source>expected stop, since nobody drives, found {}</source>
        <translation>erwartet wurde stop, da niemand fährt, gefunden {}</translation>
    </message>
    <message>
        <source>expected YAML, found a mistake: {}</source>
        <translation>erwartet wurde YAML, gefunden ein Fehler: {}</translation>
    </message>
    <message>
        <source>{}: expected a robot&apos;s file, found none that can be read</source>
        <translation>{}: erwartet wurde die Datei eines Roboters, gefunden wurde keine lesbare</translation>
    </message>
    <message>
        <source>expected what the topic carries, such as points, found nothing</source>
        <translation>erwartet wurde, was das Topic trägt, etwa points, gefunden nichts</translation>
    </message>
    <message>
        <source>expected one stream of this role, found {} of line {} again</source>
        <translation>erwartet wurde ein einziger Strom dieser Rolle, gefunden noch einmal {} aus Zeile {}</translation>
    </message>
    <message>
        <source>expected a topic of its own, found {} of line {} again</source>
        <translation>erwartet wurde ein eigenes Topic, gefunden noch einmal {} aus Zeile {}</translation>
    </message>
    <message>
        <source>expected the camera that it belongs to, a name under sensors, found nothing</source>
        <translation>erwartet wurde die Kamera, zu der er gehört, ein Name unter sensors, gefunden nichts</translation>
    </message>
    <message>
        <source>expected a name under sensors, which has none, found {}</source>
        <translation>erwartet wurde ein Name unter sensors, wo keiner steht, gefunden {}</translation>
    </message>
    <message>
        <source>expected {} (under sensors), found {}{}</source>
        <translation>erwartet wurde {} (unter sensors), gefunden {}{}</translation>
    </message>
    <message>
        <source>expected {} for {}, found {}{}</source>
        <translation>erwartet wurde {} für {}, gefunden {}{}</translation>
    </message>
    <message>
        <source>expected a topic such as /kurt3d/odom (words of letters, digits and _ that begin with no digit), found {}</source>
        <translation>erwartet wurde ein Topic wie /kurt3d/odom (Wörter aus Buchstaben, Ziffern und _, die nicht mit einer Ziffer beginnen), gefunden {}</translation>
    </message>
    <message>
        <source>expected a topic of the robot, found one of the stations: {}</source>
        <translation>erwartet wurde ein Topic des Roboters, gefunden eines der Stationen: {}</translation>
    </message>
    <message>
        <source>expected 0, since a stop never grows old, found &quot;{}&quot;</source>
        <translation>erwartet wurde 0, da ein STOP nie veraltet, gefunden &quot;{}&quot;</translation>
    </message>
    <message>
        <source>expected it only for commands that have a stamp, found it for {} of type {}</source>
        <translation>erwartet nur für Befehle mit Zeitstempel, gefunden für {} vom Typ {}</translation>
    </message>
    <message>
        <source>expected it only for diagnostics, found it for {} of type {}</source>
        <translation>erwartet nur für diagnostics, gefunden für {} vom Typ {}</translation>
    </message>
    <message>
        <source>expected it only for thermal, found it for {} of type {}</source>
        <translation>erwartet nur für thermal, gefunden für {} vom Typ {}</translation>
    </message>
    <message>
        <source>expected a list of topics, found nothing</source>
        <translation>erwartet wurde eine Liste von Topics, gefunden nichts</translation>
    </message>
    <message>
        <source>expected one YAML document, found a second one</source>
        <translation>erwartet wurde ein einziges YAML-Dokument, gefunden ein zweites</translation>
    </message>
    <message>
        <source>expected no alias, found one (*name)</source>
        <translation>erwartet wurde kein Alias, gefunden einer (*name)</translation>
    </message>
    <message>
        <source>expected no anchor, found one (&amp;name)</source>
        <translation>erwartet wurde kein Anker, gefunden einer (&amp;name)</translation>
    </message>
    <message>
        <source>expected no tag, found {}</source>
        <translation>erwartet wurde kein Tag, gefunden {}</translation>
    </message>
    <message>
        <source>expected at most {} levels, found more</source>
        <translation>erwartet wurden höchstens {} Ebenen, gefunden mehr</translation>
    </message>
    <message>
        <source>expected UTF-8 text, found byte 0x{:02x}</source>
        <translation>erwartet wurde UTF-8-Text, gefunden Byte 0x{:02x}</translation>
    </message>
    <message>
        <source>expected spaces before the first word, found a tab</source>
        <translation>erwartet wurden Leerzeichen vor dem ersten Wort, gefunden ein Tabulator</translation>
    </message>
    <message>
        <source>{}: expected at most {} bytes, found more</source>
        <translation>{}: erwartet wurden höchstens {} Bytes, gefunden mehr</translation>
    </message>
    <message>
        <source>expected keys and values, found {}</source>
        <translation>erwartet wurden Schlüssel und Werte, gefunden {}</translation>
    </message>
    <message>
        <source>keys and values</source>
        <translation>Schlüssel und Werte</translation>
    </message>
    <message>
        <source>a list of {}</source>
        <translation>eine Liste der Länge {}</translation>
    </message>
    <message>
        <source>, did you mean {}?</source>
        <translation>, ist {} gemeint?</translation>
    </message>
    <message>
        <source>{} or {}</source>
        <translation>{} oder {}</translation>
    </message>
    <message>
        <source>{}: {} errors more</source>
        <translation>{}: {} weitere Fehler</translation>
    </message>
    <message>
        <source>expected one of the keys {}, found {}{}</source>
        <translation>erwartet wurde einer der Schlüssel {}, gefunden {}{}</translation>
    </message>
    <message>
        <source>expected a name of at most {} letters, digits and _ that begins with a letter, found {}</source>
        <translation>erwartet wurde ein Name aus höchstens {} Buchstaben, Ziffern und _, der mit einem Buchstaben beginnt, gefunden {}</translation>
    </message>
    <message>
        <source>expected each key once, found {} of line {} again</source>
        <translation>erwartet wurde jeder Schlüssel einmal, gefunden noch einmal {} aus Zeile {}</translation>
    </message>
    <message>
        <source>expected a text of {} to {} printable characters, found {}</source>
        <translation>erwartet wurde ein Text aus {} bis {} druckbaren Zeichen, gefunden {}</translation>
    </message>
    <message>
        <source>expected true or false, found {}</source>
        <translation>erwartet wurde true oder false, gefunden {}</translation>
    </message>
    <message>
        <source>expected a number from {} to {}{}, found {}</source>
        <translation>erwartet wurde eine Zahl von {} bis {}{}, gefunden {}</translation>
    </message>
    <message>
        <source>expected a whole number from {} to {}, found {}</source>
        <translation>erwartet wurde eine ganze Zahl von {} bis {}, gefunden {}</translation>
    </message>
    <message>
        <source>expected {} numbers from {} to {}{}, found {}</source>
        <translation>erwartet wurden {} Zahlen von {} bis {}{}, gefunden {}</translation>
    </message>
    <message>
        <source>expected {}, found {}{}</source>
        <translation>erwartet wurde {}, gefunden {}{}</translation>
    </message>
    <message>
        <source>expected a list, found {}</source>
        <translation>erwartet wurde eine Liste, gefunden {}</translation>
    </message>
    <message>
        <source>{}: expected limits of alarms, found no file that can be read</source>
        <translation>{}: erwartet wurden Grenzwerte der Alarme, gefunden wurde keine lesbare Datei</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>expected x y z [m] and a quaternion x y z w of length 1</source>
        <translation>erwartet wurden x y z [m] und eine Quaternion x y z w der Länge 1</translation>
    </message>
    <message>
        <source>expected a distance [m] and a share from 0 to 1</source>
        <translation>erwartet wurden ein Abstand [m] und ein Anteil von 0 bis 1</translation>
    </message>
    <message>
        <source>expected a count and two amounts, none below 0</source>
        <translation>erwartet wurden eine Anzahl und zwei Größen, keine unter 0</translation>
    </message>
    <message>
        <source>expected counts and amounts, none below 0, and no more wrong finds than finds</source>
        <translation>erwartet wurden Anzahlen und Größen, keine unter 0, und nicht mehr falsche Funde als Funde</translation>
    </message>
    <message>
        <source>stands in this file already</source>
        <translation>steht schon in dieser Datei</translation>
    </message>
    <message>
        <source>expected distances above 0 and up to 1000 m</source>
        <translation>erwartet wurden Abstände über 0 und bis 1000 m</translation>
    </message>
    <message>
        <source>expected at least one distance</source>
        <translation>erwartet wurde mindestens ein Abstand</translation>
    </message>
    <message>
        <source>expected a list of key scans</source>
        <translation>erwartet wurde eine Liste von Schlüsselscans</translation>
    </message>
    <message>
        <source>{}: {} scans are more than it takes</source>
        <translation>{}: {} Scans sind mehr, als die Datei fasst</translation>
    </message>
    <message>
        <source>expected one of pane, horizontal and vertical</source>
        <translation>erwartet wurde genau eines von pane, horizontal und vertical</translation>
    </message>
    <message>
        <source>expected letters, digits, _ . and -</source>
        <translation>erwartet wurden Buchstaben, Ziffern, _ . und -</translation>
    </message>
    <message>
        <source>stands in this layout already</source>
        <translation>steht schon in diesem Layout</translation>
    </message>
    <message>
        <source>expected a list of 2 to {} places</source>
        <translation>erwartet wurde eine Liste von 2 bis {} Plätzen</translation>
    </message>
    <message>
        <source>expected keys and values</source>
        <translation>erwartet wurden Schlüssel und Werte</translation>
    </message>
    <message>
        <source>expected a command or button and its text</source>
        <translation>erwartet wurde ein Befehl oder Knopf und der Text dazu</translation>
    </message>
    <message>
        <source>is too long, or stands here twice</source>
        <translation>ist zu lang oder steht hier zweimal</translation>
    </message>
    <message>
        <source>expected the places of panes, found nothing</source>
        <translation>erwartet wurden die Plätze der Teilfenster, gefunden nichts</translation>
    </message>
    <message>
        <source>expected what the window wrote here</source>
        <translation>erwartet wurde, was das Fenster hier geschrieben hat</translation>
    </message>
    <message>
        <source>expected keys of this file</source>
        <translation>erwartet wurden Schlüssel dieser Datei</translation>
    </message>
    <message>
        <source>expected at most 32 patterns such as &quot;V-#*&quot;</source>
        <translation>erwartet wurden höchstens 32 Muster wie &quot;V-#*&quot;</translation>
    </message>
    <message>
        <source>expected JSON, found a mistake: {}</source>
        <translation>erwartet wurde JSON, gefunden ein Fehler: {}</translation>
    </message>
    <message>
        <source>{}: expected the rules of a score, found no file that can be read</source>
        <translation>{}: erwartet wurden Regeln einer Wertung, gefunden wurde keine lesbare Datei</translation>
    </message>
    <message>
        <source>expected 3 to {} corners, found {}</source>
        <translation>erwartet wurden 3 bis {} Ecken, gefunden {}</translation>
    </message>
    <message>
        <source>expected corners that differ, found [{}, {}] twice in a row</source>
        <translation>erwartet wurden verschiedene Ecken, gefunden [{}, {}] zweimal hintereinander</translation>
    </message>
    <message>
        <source>expected sides that do not cross, found side {} crossing side {}</source>
        <translation>erwartet wurden Seiten, die sich nicht kreuzen, gefunden Seite {}, die Seite {} kreuzt</translation>
    </message>
    <message>
        <source>expected an area, found {:.3g} square metres</source>
        <translation>erwartet wurde eine Fläche, gefunden {:.3g} Quadratmeter</translation>
    </message>
    <message>
        <source>{}: ends within what was being written: the last moment before is missing</source>
        <translation>{}: endet mitten in dem, was gerade geschrieben wurde: der letzte Moment davor fehlt</translation>
    </message>
    <message>
        <source>{}: its header is broken</source>
        <translation>{}: der Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>{}: frame {} is broken, {} follow</source>
        <translation>{}: Rahmen {} ist beschädigt, {} folgen</translation>
    </message>
    <message>
        <source>{}: expected {} messages, as they were counted, found {}: {} are missing</source>
        <translation>{}: {} Nachrichten erwartet, so wie sie gezählt wurden, {} gefunden: {} fehlen</translation>
    </message>
    <message>
        <source>{}: and {} more messages with fewer bytes</source>
        <translation>{}: und {} weitere Nachrichten mit zu wenigen Bytes</translation>
    </message>
    <message>
        <source>{}-wal: expected it, since the writer of {} was cut off, found nothing: what was written last may be missing</source>
        <translation>{}-wal: erwartet, da das Schreiben von {} abgebrochen ist, aber nicht gefunden: was zuletzt geschrieben wurde, fehlt vielleicht</translation>
    </message>
    <message>
        <source>picture: expected at most {} bytes when it is decoded, found {}</source>
        <translation>Bild: höchstens {} Bytes im entpackten Bild erwartet, {} gefunden</translation>
    </message>
    <message>
        <source>picture: expected at most {} scans and {} pixels in all of them, found {} scans of {}</source>
        <translation>Bild: höchstens {} Durchgänge mit zusammen {} Pixeln erwartet, {} Durchgänge mit je {} gefunden</translation>
    </message>
    <message>
        <source>picture: PNG: expected a header of a known kind</source>
        <translation>Bild: PNG: Kopf einer bekannten Art erwartet</translation>
    </message>
    <message>
        <source>picture: PNG: expected data of {} bytes for its pixels, found more</source>
        <translation>Bild: PNG: {} Bytes für die Pixel erwartet, mehr gefunden</translation>
    </message>
    <message>
        <source>{}: write this below sensors, {}, by hand: {}</source>
        <translation>{}: von Hand unter sensors, {} einzutragen: {}</translation>
    </message>
    <message>
        <source>{}: has several scanners; scans of {} are taken (`maps: true` in its file names another)</source>
        <translation>{}: hat mehrere Scanner; genommen werden die Scans von {} (`maps: true` in seiner Datei nennt einen anderen)</translation>
    </message>
    <message>
        <source>expected one stream that makes the map, found {} of line {} again</source>
        <translation>einen Strom erwartet, der die Karte macht, {} aus Zeile {} noch einmal gefunden</translation>
    </message>
    <message>
        <source>environment variable {}: expected {}, found &quot;{}&quot;</source>
        <translation>Umgebungsvariable {}: {} erwartet, „{}“ gefunden</translation>
    </message>
    <message>
        <source>the folder of a keystore</source>
        <translation>den Ordner eines Schlüsselspeichers</translation>
    </message>
    <message>
        <source>environment variable {}: with {} no robot can be found; unset it, or name a network card (--interface) or an address (--peer)</source>
        <translation>Umgebungsvariable {}: mit {} ist kein Roboter zu finden; aufheben, oder eine Netzwerkkarte (--interface) oder eine Adresse (--peer) nennen</translation>
    </message>
    <message>
        <source>{}: no scans in it, expected a topic of sensor_msgs/msg/PointCloud2, or of sensor_msgs/msg/LaserScan with odometry{}</source>
        <translation>{}: keine Scans darin, erwartet wurde ein Topic mit sensor_msgs/msg/PointCloud2, oder mit sensor_msgs/msg/LaserScan und Odometrie{}</translation>
    </message>
    <message>
        <source>expected it, found nothing</source>
        <translation>wird erwartet, fehlt aber</translation>
    </message>
    <message>
        <source>expected a map that is not turned, found a yaw of {:g}</source>
        <translation>erwartet wurde eine ungedrehte Karte, gefunden wurde ein Gierwinkel von {:g}</translation>
    </message>
    <message>
        <source>{}: expected a binary PGM (P5) with 8 bits a pixel</source>
        <translation>{}: erwartet wurde ein binäres PGM (P5) mit 8 Bit je Pixel</translation>
    </message>
    <message>
        <source>{}: expected at most {} pixels, found {} x {}</source>
        <translation>{}: erwartet wurden höchstens {} Pixel, gefunden wurden {} x {}</translation>
    </message>
    <message>
        <source>{}: expected {} bytes of pixels, found {}</source>
        <translation>{}: erwartet wurden {} Bytes mit Pixeln, gefunden wurden {}</translation>
    </message>
    <message>
        <source>{}: cannot be read to its end</source>
        <translation>{}: lässt sich nicht bis zum Ende lesen</translation>
    </message>
    <message>
        <source>expected it only for points and ranges, found it for {} of type {}</source>
        <translation>nur für points und ranges erwartet, gefunden für {} vom Typ {}</translation>
    </message>
    <message>
        <source>{}: expected a folder that does not exist yet</source>
        <translation>{}: erwartet wurde ein Ordner, den es noch nicht gibt</translation>
    </message>
    <message>
        <source>{}: is not written: cancelled</source>
        <translation>{}: wird nicht geschrieben: abgebrochen</translation>
    </message>
    <message>
        <source>{}: byte 0: expected the beginning of an MCAP file</source>
        <translation>{}: Byte 0: erwartet wurde der Anfang einer MCAP-Datei</translation>
    </message>
    <message>
        <source>expected a chunk, found one that is cut off or broken</source>
        <translation>erwartet wurde ein Block, gefunden wurde ein abgeschnittener oder beschädigter</translation>
    </message>
    <message>
        <source>expected a chunk compressed by zstd or lz4, found &quot;{}&quot;</source>
        <translation>erwartet wurde ein mit zstd oder lz4 komprimierter Block, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>the chunk is cut off; its beginning is read</source>
        <translation>der Block ist abgeschnitten; sein Anfang wird gelesen</translation>
    </message>
    <message>
        <source>expected a chunk of {} bytes, found {} that can be decompressed</source>
        <translation>erwartet wurde ein Block von {} Bytes, entpacken lassen sich {}</translation>
    </message>
    <message>
        <source>the chunk is damaged: its checksum is wrong</source>
        <translation>der Block ist beschädigt: seine Prüfsumme ist falsch</translation>
    </message>
    <message>
        <source>byte {}: {}</source>
        <translation>Byte {}: {}</translation>
    </message>
    <message>
        <source>message {}: expected a message where the index says, found none</source>
        <translation>Nachricht {}: wo das Verzeichnis sie nennt, wurde keine gefunden</translation>
    </message>
    <message>
        <source>expected at most {} messages; those after them are left out</source>
        <translation>erwartet wurden höchstens {} Nachrichten; die weiteren werden ausgelassen</translation>
    </message>
    <message>
        <source>the file ends within this record: what follows is missing</source>
        <translation>die Datei endet in diesem Eintrag: was folgt, fehlt</translation>
    </message>
    <message>
        <source>its writer did not finish it</source>
        <translation>wer sie schrieb, hat sie nicht abgeschlossen</translation>
    </message>
    <message>
        <source>expected at most {} topics</source>
        <translation>erwartet wurden höchstens {} Topics</translation>
    </message>
    <message>
        <source>{}: expected a bag&apos;s file, found an empty one</source>
        <translation>{}: erwartet wurde die Datei eines Bags, gefunden wurde eine leere</translation>
    </message>
    <message>
        <source>{}: expected a bag in SQLite or MCAP files (sqlite3, mcap), found storage &quot;{}&quot;; `ros2 bag convert` turns it into one</source>
        <translation>{}: erwartet wurde ein Bag in SQLite- oder MCAP-Dateien (sqlite3, mcap), gefunden wurde der Speicher „{}“; `ros2 bag convert` macht daraus eines</translation>
    </message>
    <message>
        <source>{}: expected a bag in SQLite or MCAP files (.db3, .mcap), found {}; `ros2 bag convert` turns it into one</source>
        <translation>{}: erwartet wurde ein Bag in SQLite- oder MCAP-Dateien (.db3, .mcap), gefunden wurde {}; `ros2 bag convert` macht daraus eines</translation>
    </message>
    <message>
        <source>{}: is of another kind than the bag&apos;s other files, and is not read</source>
        <translation>{}: ist anderer Art als die übrigen Dateien des Bags und wird nicht gelesen</translation>
    </message>
    <message>
        <source>{}: topic {}: expected messages compressed by zstd, found one that is damaged</source>
        <translation>{}: Topic {}: erwartet wurden zstd-komprimierte Nachrichten, eine ist beschädigt</translation>
    </message>
    <message>
        <source>{}: is compressed twice</source>
        <translation>{}: ist doppelt komprimiert</translation>
    </message>
    <message>
        <source>{}: expected a bag without compression, or with zstd, found compression &quot;{}&quot;; `ros2 bag convert` writes one without</source>
        <translation>{}: erwartet wurde ein Bag ohne Kompression oder mit zstd, gefunden wurde die Kompression „{}“; `ros2 bag convert` schreibt eines ohne</translation>
    </message>
    <message>
        <source>expected a file compressed by zstd, found one that is damaged</source>
        <translation>erwartet wurde eine zstd-komprimierte Datei, gefunden wurde eine beschädigte</translation>
    </message>
    <message>
        <source>{} cannot be written</source>
        <translation>{} lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>expected a file compressed by zstd, found one that is cut off</source>
        <translation>erwartet wurde eine zstd-komprimierte Datei, gefunden wurde eine abgeschnittene</translation>
    </message>
    <message>
        <source>{}: expected {} MB of free space in {} to unpack it, found {} MB; TMPDIR names another folder</source>
        <translation>{}: zum Entpacken werden {} MB freier Platz in {} gebraucht, frei sind {} MB; TMPDIR nennt einen anderen Ordner</translation>
    </message>
    <message>
        <source>{}: cannot be unpacked in {}: {}</source>
        <translation>{}: lässt sich in {} nicht entpacken: {}</translation>
    </message>
    <message>
        <source>expected a type, found &quot;{}&quot;</source>
        <translation>erwartet wurde ein Typ, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>{}: expected a text of at most {} bytes</source>
        <translation>{}: erwartet wurde ein Text von höchstens {} Bytes</translation>
    </message>
    <message>
        <source>{}: its text lacks the type {}</source>
        <translation>{}: in seinem Text fehlt der Typ {}</translation>
    </message>
    <message>
        <source>{}: expected a bag of ROS 1 in format 2.0</source>
        <translation>{}: erwartet wurde ein Bag von ROS 1 im Format 2.0</translation>
    </message>
    <message>
        <source>expected a chunk compressed by bz2 or lz4, found &quot;{}&quot;</source>
        <translation>erwartet wurde ein mit bz2 oder lz4 komprimierter Block, gefunden wurde „{}“</translation>
    </message>
    <message>
        <source>{}: is not written: messages of {} were dropped</source>
        <translation>{}: wird nicht geschrieben: Nachrichten von {} gingen verloren</translation>
    </message>
    <message>
        <source>{}: cannot be copied: {}</source>
        <translation>{}: lässt sich nicht kopieren: {}</translation>
    </message>
    <message>
        <source>{}: expected a folder outside of the bag</source>
        <translation>{}: erwartet wurde ein Ordner außerhalb des Bags</translation>
    </message>
    <message>
        <source>expected a chunk of at most {} bytes, found {}</source>
        <translation>erwartet wurde ein Block von höchstens {} Bytes, gefunden wurden {}</translation>
    </message>
    <message>
        <source>{}: expected a bag: metadata.yaml and files that end in .db3, .mcap or .bag</source>
        <translation>{}: erwartet wurde ein Bag: metadata.yaml und Dateien, die auf .db3, .mcap oder .bag enden</translation>
    </message>
    <message>
        <source>{}: is a copy of a mission in MCAP, without the numbers by which finds name their evidence: expected the mission itself</source>
        <translation>{}: ist die Kopie eines Einsatzes in MCAP, ohne die Nummern, mit denen Funde ihre Belege nennen: erwartet wurde der Einsatz selbst</translation>
    </message>
    <message>
        <source>{}: is a copy of a mission in MCAP, for other programs: expected the mission itself</source>
        <translation>{}: ist die Kopie eines Einsatzes in MCAP, für andere Programme: erwartet wurde der Einsatz selbst</translation>
    </message>
    <message>
        <source>expected a service such as /kurt3d/e_stop, found nothing</source>
        <translation>erwartet wurde ein Dienst wie /kurt3d/e_stop, gefunden nichts</translation>
    </message>
    <message>
        <source>expected a service such as /kurt3d/e_stop (words of letters, digits and _ that begin with no digit), found {}</source>
        <translation>erwartet wurde ein Dienst wie /kurt3d/e_stop (Wörter aus Buchstaben, Ziffern und _, die mit keiner Ziffer beginnen), gefunden {}</translation>
    </message>
    <message>
        <source>expected true, since a release gives no goals back, found false</source>
        <translation>erwartet wurde true, denn das Freigeben bringt keine Ziele zurück, gefunden false</translation>
    </message>
    <message>
        <source>expected a service of its own, found {} of line {} again</source>
        <translation>erwartet wurde ein eigener Dienst, gefunden noch einmal {} aus Zeile {}</translation>
    </message>
    <message>
        <source>{}: nobody offers its navigation {}</source>
        <translation>{}: Niemand bietet seine Navigation {} an</translation>
    </message>
    <message>
        <source>{}: its file names no service {}</source>
        <translation>{}: Seine Datei nennt keinen Dienst {}</translation>
    </message>
    <message>
        <source>picture of depths: expected 16UC1 or 32FC1, found &quot;{}&quot;</source>
        <translation>Tiefenbild: erwartet 16UC1 oder 32FC1, gefunden &quot;{}&quot;</translation>
    </message>
    <message>
        <source>picture of depths: its camera_info holds no calibration that is known</source>
        <translation>Tiefenbild: seine camera_info enthält keine bekannte Kalibrierung</translation>
    </message>
    <message>
        <source>picture of depths: its RVL data are damaged</source>
        <translation>Tiefenbild: seine RVL-Daten sind beschädigt</translation>
    </message>
    <message>
        <source>picture of depths: expected at most {} pixels, found {} x {}</source>
        <translation>Tiefenbild: erwartet höchstens {} Bildpunkte, gefunden {} x {}</translation>
    </message>
    <message>
        <source>picture of depths: expected a PNG of 16 bits</source>
        <translation>Tiefenbild: erwartet ein PNG mit 16 Bit</translation>
    </message>
    <message>
        <source>picture of depths: expected at least {} bytes, found {}</source>
        <translation>Tiefenbild: erwartet mindestens {} Bytes, gefunden {}</translation>
    </message>
    <message>
        <source>picture of depths: expected a PNG after 12 bytes, found {} other bytes (format &quot;{}&quot;)</source>
        <translation>Tiefenbild: erwartet ein PNG nach 12 Bytes, gefunden {} andere Bytes (Format &quot;{}&quot;)</translation>
    </message>
    <message>
        <source>picture: of a video, and damaged; waiting for the next key picture</source>
        <translation>Bild: aus einem Video und beschädigt; warte auf das nächste Schlüsselbild</translation>
    </message>
    <message>
        <source>picture: of a video whose last key picture is missing or long ago: the encoder sends them too seldom (gop_size), or pictures are lost</source>
        <translation>Bild: aus einem Video, dessen letztes Schlüsselbild fehlt oder lange her ist: der Encoder sendet sie zu selten (gop_size), oder Bilder gehen verloren</translation>
    </message>
    <message>
        <source>picture: of a video, expected at most {} pixels, found {}</source>
        <translation>Bild: aus einem Video, erwartet höchstens {} Bildpunkte, gefunden {}</translation>
    </message>
    <message>
        <source>picture: of a video that libavcodec does not decode here</source>
        <translation>Bild: aus einem Video, das libavcodec hier nicht dekodiert</translation>
    </message>
    <message>
        <source>expected a name of the group, of letters, digits and _, found {}</source>
        <translation>erwartet: ein Name der Gruppe aus Buchstaben, Ziffern und _, gefunden: {}</translation>
    </message>
    <message>
        <source>expected at most {}, found {}</source>
        <translation>erwartet: höchstens {}, gefunden: {}</translation>
    </message>
    <message>
        <source>expected a list of joints, found none</source>
        <translation>erwartet: eine Liste von Gelenken, gefunden: keine</translation>
    </message>
    <message>
        <source>expected the name of a joint as in joint_states, found nothing</source>
        <translation>erwartet: der Name eines Gelenks wie in joint_states, gefunden: nichts</translation>
    </message>
    <message>
        <source>expected each joint once, found {} again</source>
        <translation>erwartet: jedes Gelenk einmal, gefunden: {} noch einmal</translation>
    </message>
    <message>
        <source>expected less than upper, {}{}, found {}</source>
        <translation>erwartet: weniger als upper, {}{}, gefunden: {}</translation>
    </message>
    <message>
        <source>expected lower and upper of a prismatic joint, found not both</source>
        <translation>erwartet: lower und upper eines Schubgelenks, gefunden: nicht beide</translation>
    </message>
    <message>
        <source>expected how long it is, found nothing</source>
        <translation>erwartet: seine Länge, gefunden: nichts</translation>
    </message>
    <message>
        <source>expected a joint that stands before it, found {}</source>
        <translation>erwartet: ein Gelenk, das davor steht, gefunden: {}</translation>
    </message>
    <message>
        <source>expected one of the group&apos;s joints, each once, found {}</source>
        <translation>erwartet: eines der Gelenke der Gruppe, jedes einmal, gefunden: {}</translation>
    </message>
    <message>
        <source>expected its title, found nothing</source>
        <translation>erwartet: ein Titel, gefunden: nichts</translation>
    </message>
    <message>
        <source>expected {} positions, one for each joint, found none</source>
        <translation>erwartet: {} Stellungen, eine für jedes Gelenk, gefunden: keine</translation>
    </message>
    <message>
        <source>expected {} within its limits, found {}</source>
        <translation>erwartet: {} innerhalb seiner Grenzen, gefunden: {}</translation>
    </message>
    <message>
        <source>expected a name of its own, found {} again</source>
        <translation>erwartet: ein eigener Name, gefunden: {} noch einmal</translation>
    </message>
    <message>
        <source>expected a stream joint_command with the group {}, found none</source>
        <translation>erwartet: ein Datenstrom joint_command mit der Gruppe {}, gefunden: keiner</translation>
    </message>
    <message>
        <source>expected it only for joint_command, found it for {}</source>
        <translation>nur für joint_command erwartet, gefunden bei {}</translation>
    </message>
    <message>
        <source>expected the name of one of joint_groups, found {}{}</source>
        <translation>erwartet: ein Name aus joint_groups, gefunden: {}{}</translation>
    </message>
    <message>
        <source>expected one stream for each group, found {} of line {} again</source>
        <translation>erwartet: ein Datenstrom für jede Gruppe, gefunden: {} aus Zeile {} noch einmal</translation>
    </message>
    <message>
        <source>expected positions in a JointTrajectory, found a group that is commanded by velocity</source>
        <translation>erwartet: Stellungen in einer JointTrajectory, gefunden: eine Gruppe, die durch Geschwindigkeiten bewegt wird</translation>
    </message>
    <message>
        <source>messages of type {} are not known, so nothing in them is read</source>
        <translation>Nachrichten des Typs {} sind nicht bekannt, also wird nichts daraus gelesen</translation>
    </message>
    <message>
        <source>expected another number than 0</source>
        <translation>erwartet eine andere Zahl als 0</translation>
    </message>
    <message>
        <source>expected another title for each number, found {} again</source>
        <translation>erwartet für jede Zahl einen anderen Titel, gefunden wieder {}</translation>
    </message>
    <message>
        <source>expected the path of a number in the message, such as temperature or cells[2].voltage, found {}</source>
        <translation>erwartet den Pfad einer Zahl in der Nachricht, etwa temperature oder cells[2].voltage, gefunden {}</translation>
    </message>
    <message>
        <source>expected at least {} (that of {}), found &quot;{}&quot;</source>
        <translation>erwartet mindestens {} (das von {}), gefunden „{}“</translation>
    </message>
    <message>
        <source>expected a list of numbers in messages of type {}, found nothing</source>
        <translation>erwartet eine Liste von Zahlen in Nachrichten des Typs {}, gefunden nichts</translation>
    </message>
    <message>
        <source>expected 1 to {} numbers, found {}</source>
        <translation>erwartet 1 bis {} Zahlen, gefunden {}</translation>
    </message>
    <message>
        <source>expected it only for reading, found it for {}</source>
        <translation>nur für reading erwartet, gefunden bei {}</translation>
    </message>
    <message>
        <source>{}: it came with the program, and neither HOME nor XDG_CONFIG_HOME tells where a copy goes</source>
        <translation>{}: Sie kam mit dem Programm, und weder HOME noch XDG_CONFIG_HOME sagt, wohin eine Kopie soll</translation>
    </message>
    <message>
        <source>{}: write this by hand: footprint: {}, height: {}, and places of sensors</source>
        <translation>{}: Bitte von Hand eintragen: footprint: {}, height: {} und die Orte der Sensoren</translation>
    </message>
    <message>
        <source>expected a folder, at most {} of them, found {}</source>
        <translation>erwartet: ein Ordner, höchstens {} davon, gefunden: {}</translation>
    </message>
    <message>
        <source>expected sequences of {} messages, found {}; the others are left out</source>
        <translation>erwartet wurden die Nummern von {} Nachrichten, gefunden {}; die übrigen bleiben weg</translation>
    </message>
    <message>
        <source>{}: expected a sequence of its own for each message; {} are left out</source>
        <translation>{}: erwartet wurde für jede Nachricht eine eigene Nummer; {} bleiben weg</translation>
    </message>
</context>
<context>
    <name>leitstand::EvidenceStrip</name>
    <message>
        <source>Pictures of the find</source>
        <translation>Bilder des Fundes</translation>
    </message>
    <message>
        <source>reads the pictures…</source>
        <translation>liest die Bilder…</translation>
    </message>
    <message>
        <source>no pictures</source>
        <translation>keine Bilder</translation>
    </message>
</context>
<context>
    <name>leitstand::FieldRowsModel</name>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>%1
A click plots it</source>
        <translation>%1
Ein Klick zeichnet den Verlauf</translation>
    </message>
</context>
<context>
    <name>leitstand::FileCommands</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>&amp;Open scans…</source>
        <translation>&amp;Scans öffnen…</translation>
    </message>
    <message>
        <source>Adds scan files to the map</source>
        <translation>Fügt der Karte Scandateien hinzu</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>&amp;Ordner öffnen…</translation>
    </message>
    <message>
        <source>Adds all scans of a folder to the map</source>
        <translation>Fügt der Karte alle Scans eines Ordners hinzu</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>&amp;Bild speichern…</translation>
    </message>
    <message>
        <source>Saves the map as it is shown, in full detail</source>
        <translation>Speichert die Karte, wie sie gezeigt wird, in voller Auflösung</translation>
    </message>
    <message>
        <source>&amp;Close scans</source>
        <translation>Scans s&amp;chließen</translation>
    </message>
    <message>
        <source>Empties the map</source>
        <translation>Leert die Karte</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>Open scans</source>
        <translation>Scans öffnen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a folder of scans</source>
        <translation>Einen Ordner mit Scans öffnen</translation>
    </message>
    <message>
        <source>Save the map&apos;s picture</source>
        <translation>Bild der Karte speichern</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>JPEG pictures (*.jpg)</source>
        <translation>JPEG-Bilder (*.jpg)</translation>
    </message>
    <message>
        <source>map.png</source>
        <translation>karte.png</translation>
    </message>
    <message>
        <source>%1: the picture could not be written</source>
        <translation>%1: das Bild konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>&amp;Forget these</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>Scans (%1)</translation>
    </message>
</context>
<context>
    <name>leitstand::FindMoves</name>
    <message>
        <source>scans were registered again</source>
        <translation>Scans neu registriert wurden</translation>
    </message>
    <message>
        <source>a loop was closed</source>
        <translation>eine Schleife geschlossen wurde</translation>
    </message>
    <message>
        <source>the operator corrected scans</source>
        <translation>der Operator Scans korrigiert hat</translation>
    </message>
    <message>
        <source>a decision was taken back</source>
        <translation>eine Entscheidung zurückgenommen wurde</translation>
    </message>
    <message>
        <source>moved %1 m at %2, since %3</source>
        <translation>um %1 m bewegt um %2, weil %3</translation>
    </message>
    <message>
        <source>%1 %2 m</source>
        <comment>V1 0.32 m</comment>
        <translation>%1 %2 m</translation>
    </message>
    <message>
        <source>%1 moved, since %2</source>
        <translation>%1 bewegt, weil %2</translation>
    </message>
</context>
<context>
    <name>leitstand::FindPointing</name>
    <message>
        <source>Victim where I &amp;click</source>
        <translation>Opfer dort, wo ich &amp;klicke</translation>
    </message>
    <message>
        <source>Then click on it in a picture, in the virtual scan or on the map; in pictures and the virtual scan a click with Shift does the same at any time</source>
        <translation>Danach im Bild, im virtuellen Scan oder auf der Karte darauf klicken; in Bildern und im virtuellen Scan geht es jederzeit mit Umschalt und Klick</translation>
    </message>
    <message>
        <source>Click where the victim is · right button: not at all</source>
        <translation>Auf den Ort des Opfers klicken · rechte Taste: gar nicht</translation>
    </message>
    <message>
        <source>Click on the victim: in a picture, in the virtual scan or on the map</source>
        <translation>Auf das Opfer klicken: im Bild, im virtuellen Scan oder auf der Karte</translation>
    </message>
    <message>
        <source>The robot is not in the map yet: nothing was filed</source>
        <translation>Der Roboter ist noch nicht in der Karte: nichts wurde erfasst</translation>
    </message>
    <message>
        <source>Then click on it in a picture, in the virtual scan or on the map</source>
        <translation>Danach im Bild, im virtuellen Scan oder auf der Karte darauf klicken</translation>
    </message>
    <message>
        <source>Hazard where I click</source>
        <translation>Gefahr dort, wo ich klicke</translation>
    </message>
    <message>
        <source>QR code where I click</source>
        <translation>QR-Code dort, wo ich klicke</translation>
    </message>
    <message>
        <source>Object where I click</source>
        <translation>Objekt dort, wo ich klicke</translation>
    </message>
    <message>
        <source>Click where it is · right button: not at all</source>
        <translation>Auf den Ort klicken · rechte Taste: gar nicht</translation>
    </message>
    <message>
        <source>Click on it: in a picture, in the virtual scan or on the map</source>
        <translation>Darauf klicken: im Bild, im virtuellen Scan oder auf der Karte</translation>
    </message>
</context>
<context>
    <name>leitstand::FindRow</name>
    <message>
        <source>part of %1</source>
        <translation>Teil von %1</translation>
    </message>
    <message>
        <source>discarded</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>trapped</source>
        <translation>eingeklemmt</translation>
    </message>
    <message>
        <source>void</source>
        <translation>Hohlraum</translation>
    </message>
    <message>
        <source>entombed</source>
        <translation>verschüttet</translation>
    </message>
</context>
<context>
    <name>leitstand::FindsByClick</name>
    <message>
        <source>Mo&amp;ve the find on the map</source>
        <translation>Fund auf der Karte ver&amp;schieben</translation>
    </message>
    <message>
        <source>Click on the map where the chosen find is</source>
        <translation>Auf der Karte anklicken, wo der gewählte Fund ist</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Victim where I &amp;click</source>
        <translation>Opfer dort, wo ich &amp;klicke</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Hazard where I click</source>
        <translation>Gefahr dort, wo ich klicke</translation>
    </message>
    <message>
        <source>QR code where I click</source>
        <translation>QR-Code dort, wo ich klicke</translation>
    </message>
    <message>
        <source>Object where I click</source>
        <translation>Objekt dort, wo ich klicke</translation>
    </message>
    <message>
        <source>Then click on it in a picture, in the virtual scan or on the map: filed with the pictures of this moment</source>
        <translation>Dann in einem Bild, im virtuellen Scan oder auf der Karte anklicken: erfasst mit den Bildern dieses Moments</translation>
    </message>
    <message>
        <source>Click where %1 is · right button: not at all</source>
        <translation>Anklicken, wo %1 ist · rechte Taste: abbrechen</translation>
    </message>
    <message>
        <source>%1 moved (as finished)</source>
        <translation>%1 verschoben (Endstand)</translation>
    </message>
    <message>
        <source>Click where it is · right button: not at all</source>
        <translation>Auf den Ort klicken · rechte Taste: gar nicht</translation>
    </message>
    <message>
        <source>%1 filed (as finished)</source>
        <translation>%1 erfasst (Endstand)</translation>
    </message>
    <message>
        <source>The robot was not in the map then: nothing was filed</source>
        <translation>Der Roboter war da nicht in der Karte: nichts wurde erfasst</translation>
    </message>
</context>
<context>
    <name>leitstand::FindsFeature</name>
    <message>
        <source>Taken back</source>
        <translation>Zurückgenommen</translation>
    </message>
    <message>
        <source>Write a n&amp;ote…</source>
        <translation>Notiz s&amp;chreiben…</translation>
    </message>
    <message>
        <source>About the moment that is shown</source>
        <translation>Zum gezeigten Zeitpunkt</translation>
    </message>
    <message>
        <source>&amp;Undo what was written</source>
        <translation>Geschriebenes &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>The mission took this find back later</source>
        <translation>Die Mission hat diesen Fund später zurückgenommen</translation>
    </message>
    <message>
        <source>%1: %2 (as finished)</source>
        <translation>%1: %2 (Endstand)</translation>
    </message>
    <message>
        <source>%1 corrected (as finished)</source>
        <translation>%1 korrigiert (Endstand)</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>Zu %1</translation>
    </message>
    <message>
        <source>Noted at %1</source>
        <translation>Notiert zu %1</translation>
    </message>
    <message>
        <source>Con&amp;firm the find</source>
        <translation>Fund &amp;bestätigen</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Bestätigen</translation>
    </message>
    <message>
        <source>&amp;Discard the find</source>
        <translation>Fund &amp;verwerfen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Form of the f&amp;ind…</source>
        <translation>Formular des F&amp;undes…</translation>
    </message>
    <message>
        <source>Form…</source>
        <translation>Formular…</translation>
    </message>
    <message>
        <source>The chosen find&apos;s form: what is known of it</source>
        <translation>Das Formular des gewählten Fundes: was man von ihm weiß</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>Notiz…</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>&amp;Merge with the nearest</source>
        <translation>Mit dem nächsten v&amp;ereinen</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Vereinen</translation>
    </message>
    <message>
        <source>The chosen find is the same as the nearest one of its kind, which gets its evidence</source>
        <translation>Der gewählte Fund ist derselbe wie der nächste seiner Art, der seine Belege erhält</translation>
    </message>
    <message>
        <source>The chosen find is one; the chosen candidate is filed</source>
        <translation>Der gewählte Fund ist einer; der gewählte Kandidat wird erfasst</translation>
    </message>
    <message>
        <source>The candidate is filed (as finished)</source>
        <translation>Der Kandidat ist erfasst (Endstand)</translation>
    </message>
    <message>
        <source>The chosen find, or candidate, is none</source>
        <translation>Der gewählte Fund oder Kandidat ist keiner</translation>
    </message>
    <message>
        <source>The candidate is dismissed (as finished)</source>
        <translation>Der Kandidat ist verworfen (Endstand)</translation>
    </message>
    <message>
        <source>Takes back what was written last in reviews</source>
        <translation>Nimmt zurück, was in Auswertungen zuletzt geschrieben wurde</translation>
    </message>
</context>
<context>
    <name>leitstand::FormPictures</name>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>%1: up to %2 °C</source>
        <translation>%1: bis %2 °C</translation>
    </message>
</context>
<context>
    <name>leitstand::FrameRowsModel</name>
    <message>
        <source>Frame</source>
        <translation>System</translation>
    </message>
    <message>
        <source>x y z [m]</source>
        <translation>x y z [m]</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
</context>
<context>
    <name>leitstand::FrameWords</name>
    <message>
        <source>It is above itself: tf uses no frame of such a circle</source>
        <translation>Es liegt über sich selbst: tf verwendet kein System eines solchen Kreises</translation>
    </message>
    <message>
        <source>Also below %1: two nodes publish it, and tf jumps between both</source>
        <translation>Auch unter %1: Zwei Knoten veröffentlichen es, und tf springt zwischen beiden</translation>
    </message>
    <message>
        <source>The highest frame of a tree</source>
        <translation>Das oberste System eines Baums</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>%1 m · roll %2, pitch %3, yaw %4</source>
        <translation>%1 m · Rollen %2, Nicken %3, Gieren %4</translation>
    </message>
    <message>
        <source>static</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>No transforms came</source>
        <translation>Es kamen keine Transformationen</translation>
    </message>
    <message>
        <source>frames: %1</source>
        <translation>Koordinatensysteme: %1</translation>
    </message>
    <message>
        <source>trees that nothing connects: %1</source>
        <translation>Bäume, die nichts verbindet: %1</translation>
    </message>
    <message>
        <source>with two parents or in a circle: %1</source>
        <translation>mit zwei Eltern oder in einem Kreis: %1</translation>
    </message>
    <message>
        <source>No transforms lead from the base to %1: the places in the robot&apos;s file count</source>
        <translation>Von der Basis führen keine Transformationen zu %1: Es gelten die Orte in der Datei des Roboters</translation>
    </message>
</context>
<context>
    <name>leitstand::FramesFeature</name>
    <message>
        <source>&amp;Frames of the robot (tf)</source>
        <translation>&amp;Koordinatensysteme des Roboters (tf)</translation>
    </message>
    <message>
        <source>The tree of its frames, where each lies in its parent, how often and when that came</source>
        <translation>Der Baum seiner Koordinatensysteme: wo jedes in seinem Elternsystem liegt, wie oft und wann das kam</translation>
    </message>
</context>
<context>
    <name>leitstand::FramesPanel</name>
    <message>
        <source>Frames</source>
        <translation>Koordinatensysteme</translation>
    </message>
    <message>
        <source>Frames of the robot, each below its parent</source>
        <translation>Koordinatensysteme des Roboters, jedes unter seinem Elternsystem</translation>
    </message>
</context>
<context>
    <name>leitstand::Freshness</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>no data yet</source>
        <translation>noch keine Daten</translation>
    </message>
    <message>
        <source>same for %1</source>
        <translation>gleich seit %1</translation>
    </message>
    <message>
        <source>the same picture for %1</source>
        <translation>dasselbe Bild seit %1</translation>
    </message>
    <message>
        <source>no data for %1</source>
        <translation>keine Daten seit %1</translation>
    </message>
</context>
<context>
    <name>leitstand::GasCell</name>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>CO₂ %1 %2 %3
%4</source>
        <translation>CO₂ %1 %2 %3
%4</translation>
    </message>
</context>
<context>
    <name>leitstand::GoTo</name>
    <message>
        <source>&amp;Go to a place</source>
        <translation>Zum &amp;Ziel fahren</translation>
    </message>
    <message>
        <source>Click where the selected robot shall go by itself, drag its heading; a double click on the floor does the same</source>
        <translation>Anklicken, wohin der gewählte Roboter selbst fahren soll, Richtung ziehen; ein Doppelklick auf den Boden tut dasselbe</translation>
    </message>
    <message>
        <source>%1 is not in the map yet</source>
        <translation>%1 ist noch nicht in der Karte</translation>
    </message>
    <message>
        <source>Click where %1 shall go, drag its heading · right button: not at all</source>
        <translation>Anklicken, wohin %1 fahren soll, Richtung ziehen · rechte Taste: abbrechen</translation>
    </message>
    <message>
        <source>%1 is not sent: it was halted</source>
        <translation>%1 wird nicht geschickt: angehalten</translation>
    </message>
    <message>
        <source>%1 was not sent: its odometry restarted, and nobody knows where</source>
        <translation>%1 wurde nicht geschickt: die Odometrie begann neu, und niemand weiß wo</translation>
    </message>
    <message>
        <source>%1 was not sent: another station has its drive control</source>
        <translation>%1 wurde nicht geschickt: das Fahrrecht hat eine andere Station</translation>
    </message>
    <message>
        <source>%1 takes no goals</source>
        <translation>%1 nimmt keine Ziele an</translation>
    </message>
    <message>
        <source>%1: the map moved under its goal, which is withdrawn; send it again</source>
        <translation>%1: Die Karte rückte unter dem Ziel, das zurückgenommen ist; senden Sie es neu</translation>
    </message>
    <message>
        <source>%1: its goal is cancelled, since it was halted</source>
        <translation>%1: Sein Ziel ist aufgehoben, da er angehalten wurde</translation>
    </message>
    <message>
        <source>%1: its goal is cancelled, since you drive</source>
        <translation>%1: Sein Ziel ist aufgehoben, da Sie fahren</translation>
    </message>
    <message>
        <source>Go there &amp;next</source>
        <translation>&amp;Danach dorthin fahren</translation>
    </message>
    <message>
        <source>Click where the selected robot shall go after the place that it is sent to now</source>
        <translation>Klicken, wohin der gewählte Roboter nach seinem jetzigen Ziel fahren soll</translation>
    </message>
    <message>
        <source>Return to &amp;start</source>
        <translation>&amp;Zum Start zurück</translation>
    </message>
    <message>
        <source>Sends the selected robot to where its trail in the map begins</source>
        <translation>Schickt den gewählten Roboter dorthin, wo seine Spur in der Karte beginnt</translation>
    </message>
    <message>
        <source>Click where %1 shall go next, drag its heading · right button: not at all</source>
        <translation>Klicken, wohin %1 danach fahren soll, ziehen für die Richtung · rechte Taste: gar nicht</translation>
    </message>
    <message>
        <source>%1 is sent to %2 places already</source>
        <translation>%1 ist schon zu %2 Orten geschickt</translation>
    </message>
    <message>
        <source>%1 has not driven yet: it has no start to return to</source>
        <translation>%1 ist noch nicht gefahren: es gibt keinen Start, zu dem er zurückkann</translation>
    </message>
    <message>
        <source>%1: where it was to go next is given up</source>
        <translation>%1: die folgenden Ziele sind aufgegeben</translation>
    </message>
</context>
<context>
    <name>leitstand::GoalQuestion</name>
    <message>
        <source>Send it to where its goal lies &amp;now</source>
        <translation>Dorthin schicken, wo sein Ziel &amp;jetzt liegt</translation>
    </message>
    <message>
        <source>Leave its goal &amp;withdrawn</source>
        <translation>Sein Ziel bleibt &amp;zurückgezogen</translation>
    </message>
    <message>
        <source>Send again</source>
        <translation>Wieder schicken</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Lassen</translation>
    </message>
    <message>
        <source>No goal was withdrawn</source>
        <translation>Kein Ziel wurde zurückgezogen</translation>
    </message>
    <message>
        <source>%1: the map moved by %2 m under its goal, which is withdrawn. Send it to where that place lies now?</source>
        <translation>%1: Die Karte hat sich unter seinem Ziel um %2 m verschoben, es ist zurückgezogen. Dorthin schicken, wo der Ort jetzt liegt?</translation>
    </message>
</context>
<context>
    <name>leitstand::GoalText</name>
    <message>
        <source>sent to its goal</source>
        <translation>zum Ziel geschickt</translation>
    </message>
    <message>
        <source>gives up its goal</source>
        <translation>gibt sein Ziel auf</translation>
    </message>
    <message>
        <source>drives to its goal</source>
        <translation>fährt zum Ziel</translation>
    </message>
    <message>
        <source>%1 m to go</source>
        <translation>noch %1 m</translation>
    </message>
    <message>
        <source>%1 has arrived</source>
        <translation>%1 ist angekommen</translation>
    </message>
    <message>
        <source>%1: its goal was cancelled</source>
        <translation>%1: Sein Ziel wurde aufgehoben</translation>
    </message>
    <message>
        <source>%1 gave up on the way to its goal</source>
        <translation>%1 hat auf dem Weg zum Ziel aufgegeben</translation>
    </message>
    <message>
        <source>%1 does not accept the goal</source>
        <translation>%1 nimmt das Ziel nicht an</translation>
    </message>
    <message>
        <source>%1 does not answer: the goal may not have reached it</source>
        <translation>%1 antwortet nicht: Das Ziel kam vielleicht nicht an</translation>
    </message>
    <message>
        <source>stuck: %1</source>
        <comment>so often on its way</comment>
        <translation>festgefahren: %1</translation>
    </message>
</context>
<context>
    <name>leitstand::GridOnMap</name>
    <message>
        <source>Next map of the &amp;robot&apos;s own</source>
        <translation>Nächste eigene Karte des &amp;Roboters</translation>
    </message>
    <message>
        <source>Grid maps and costmaps of the selected robot over the map, one after the other, then none</source>
        <translation>Raster- und Kostenkarten des gewählten Roboters über der Karte, eine nach der anderen, dann keine</translation>
    </message>
    <message>
        <source>%1 sends no map of its own</source>
        <translation>%1 sendet keine eigene Karte</translation>
    </message>
    <message>
        <source>%1: no map of its own is shown</source>
        <translation>%1: keine eigene Karte wird gezeigt</translation>
    </message>
    <message>
        <source>%1: %2 is shown once the robot is in the map</source>
        <translation>%1: %2 wird gezeigt, sobald der Roboter in der Karte ist</translation>
    </message>
    <message>
        <source>%1: %2 is empty so far</source>
        <translation>%1: %2 ist bisher leer</translation>
    </message>
    <message>
        <source>%1: %2 cannot be placed: no tf leads from &quot;%3&quot; to &quot;%4&quot;</source>
        <translation>%1: %2 ist nicht einzuordnen: kein tf führt von „%3“ nach „%4“</translation>
    </message>
    <message>
        <source>%1: %2 is shown over the map</source>
        <translation>%1: %2 wird über der Karte gezeigt</translation>
    </message>
</context>
<context>
    <name>leitstand::HandInFeature</name>
    <message>
        <source>R&amp;eport into a folder…</source>
        <translation>B&amp;ericht in einen Ordner…</translation>
    </message>
    <message>
        <source>Writes the judges&apos; folder of this mission, with what was corrected in the review</source>
        <translation>Schreibt den Ordner der Jury zu dieser Mission, mit allem, was in der Auswertung berichtigt wurde</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>Ordner für den Bericht</translation>
    </message>
    <message>
        <source>Report: %1 %</source>
        <translation>Bericht: %1 %</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
</context>
<context>
    <name>leitstand::Hearing</name>
    <message>
        <source>{}: {}; joining the network again</source>
        <translation>{}: {}; das Netz wird neu betreten</translation>
    </message>
    <message>
        <source>announced by {}, but none of its topics are</source>
        <translation>angekündigt von {}, aber keines seiner Themen</translation>
    </message>
    <message>
        <source>announced, but nothing comes: {}</source>
        <translation>angekündigt, aber nichts kommt: {}</translation>
    </message>
    <message>
        <source>{}: {}; is the sensor switched on?</source>
        <translation>{}: {}; ist der Sensor eingeschaltet?</translation>
    </message>
    <message>
        <source>{}: {}; joining again did not help: look at the robot&apos;s program, at firewalls, and at which networks both are in</source>
        <translation>{}: {}; neu betreten half nicht: das Programm des Roboters prüfen, Firewalls, und in welchen Netzen beide sind</translation>
    </message>
    <message>
        <source>announced, but never came: {}</source>
        <translation>angekündigt, aber nie gekommen: {}</translation>
    </message>
</context>
<context>
    <name>leitstand::HelpCommands</name>
    <message>
        <source>Left button</source>
        <translation>Linke Taste</translation>
    </message>
    <message>
        <source>turns the map; while measuring, picks a point</source>
        <translation>dreht die Karte; beim Messen wählt sie einen Punkt</translation>
    </message>
    <message>
        <source>Middle, Shift+left</source>
        <translation>Mitte, Umschalt+links</translation>
    </message>
    <message>
        <source>shifts the map</source>
        <translation>verschiebt die Karte</translation>
    </message>
    <message>
        <source>Wheel, right button</source>
        <translation>Rad, rechte Taste</translation>
    </message>
    <message>
        <source>zooms</source>
        <translation>zoomt</translation>
    </message>
    <message>
        <source>Arrows, +, −</source>
        <translation>Pfeiltasten, +, −</translation>
    </message>
    <message>
        <source>turn and zoom; with Shift they shift</source>
        <translation>drehen und zoomen; mit Umschalt verschieben sie</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>ends measuring</source>
        <translation>beendet das Messen</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>in the scans list: shows or hides the scan</source>
        <translation>in der Scanliste: zeigt oder verbirgt den Scan</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Umschalt+Tab</translation>
    </message>
    <message>
        <source>next and previous field</source>
        <translation>nächstes und voriges Feld</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>Lists all keys</source>
        <translation>Listet alle Tasten</translation>
    </message>
    <message>
        <source>&amp;About Leitstand</source>
        <translation>Ü&amp;ber Leitstand</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Map and lists</source>
        <translation>Karte und Listen</translation>
    </message>
    <message>
        <source>About Leitstand</source>
        <translation>Über Leitstand</translation>
    </message>
    <message>
        <source>Leitstand %1</source>
        <translation>Leitstand %1</translation>
    </message>
    <message>
        <source>The operator station for rescue robots: registers 3D laser scans into one map and shows it, after the methods of the RoboCup Rescue team Deutschland1.

Apache License 2.0</source>
        <translation>Die Bedienstation für Rettungsroboter: registriert 3D-Laserscans zu einer Karte und zeigt sie, nach den Methoden des RoboCup-Rescue-Teams Deutschland1.

Apache License 2.0</translation>
    </message>
</context>
<context>
    <name>leitstand::JointDrawing</name>
    <message>
        <source>Flippers and arm, from the right</source>
        <translation>Flipper und Arm, von rechts</translation>
    </message>
</context>
<context>
    <name>leitstand::JointRowsModel</name>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Stellung</translation>
    </message>
</context>
<context>
    <name>leitstand::JointTexts</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <translation> (%1 bis %2)</translation>
    </message>
    <message>
        <source>%1: blocked, given up</source>
        <translation>%1: blockiert, aufgegeben</translation>
    </message>
    <message>
        <source>%1: the robot does not tell where they are</source>
        <translation>%1: der Roboter meldet ihre Stellung nicht</translation>
    </message>
    <message>
        <source>%1: to %2</source>
        <translation>%1: nach %2</translation>
    </message>
    <message>
        <source>%1: no drive control</source>
        <translation>%1: kein Fahrrecht</translation>
    </message>
</context>
<context>
    <name>leitstand::JointsFeature</name>
    <message>
        <source>Joints move only with drive control of a robot that is not stopped</source>
        <translation>Gelenke bewegen sich nur mit dem Fahrrecht eines Roboters, der nicht angehalten ist</translation>
    </message>
    <message>
        <source>&amp;Next flippers or joint</source>
        <translation>&amp;Nächste Flipper oder nächstes Gelenk</translation>
    </message>
    <message>
        <source>J raises what is chosen while it is held, K lowers it</source>
        <translation>J hebt das Gewählte, solange es gedrückt ist, K senkt es</translation>
    </message>
    <message>
        <source>Gamepad moves &amp;joints</source>
        <translation>Gamepad bewegt &amp;Gelenke</translation>
    </message>
    <message>
        <source>With the trigger held, the stick that turns cameras raises and lowers what is chosen instead</source>
        <translation>Bei gehaltenem Abzug hebt und senkt der Stick der Kameras stattdessen das Gewählte</translation>
    </message>
    <message>
        <source>Joints to preset %1</source>
        <translation>Gelenke in Grundstellung %1</translation>
    </message>
    <message>
        <source>Moves all joints of the chosen group to a pose of the robot&apos;s file; Space or STOP ends it</source>
        <translation>Bewegt alle Gelenke der gewählten Gruppe in eine Stellung aus der Datei des Roboters; Leertaste oder STOP beendet das</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächste</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>flippers: a preset</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>leitstand::JointsPanel</name>
    <message>
        <source>Flippers and arm</source>
        <translation>Flipper und Arm</translation>
    </message>
    <message>
        <source>What the controls of joints move</source>
        <translation>Was die Bedienung der Gelenke bewegt</translation>
    </message>
    <message>
        <source>The file of %1 names no flippers and no arm</source>
        <translation>Die Datei von %1 nennt weder Flipper noch Arm</translation>
    </message>
</context>
<context>
    <name>leitstand::KeyColumns</name>
    <message>
        <source>Left button</source>
        <translation>Linke Taste</translation>
    </message>
    <message>
        <source>turns the map; while measuring, picks a point</source>
        <translation>dreht die Karte; wählt beim Messen einen Punkt</translation>
    </message>
    <message>
        <source>Middle, Shift+left</source>
        <translation>Mittlere, Umschalt+links</translation>
    </message>
    <message>
        <source>shifts the map</source>
        <translation>verschiebt die Karte</translation>
    </message>
    <message>
        <source>Wheel, right button</source>
        <translation>Rad, rechte Taste</translation>
    </message>
    <message>
        <source>zooms the map</source>
        <translation>zoomt die Karte</translation>
    </message>
    <message>
        <source>Arrows, +, −</source>
        <translation>Pfeile, +, −</translation>
    </message>
    <message>
        <source>in the map that has the keyboard: turn and zoom; with Shift they shift</source>
        <translation>in der Karte mit der Tastatur: drehen und zoomen; mit Umschalt verschieben</translation>
    </message>
    <message>
        <source>+, −</source>
        <translation>+, −</translation>
    </message>
    <message>
        <source>zoom the virtual scan that has the keyboard</source>
        <translation>zoomen den virtuellen Scan, der die Tastatur hat</translation>
    </message>
    <message>
        <source>Ctrl+C</source>
        <translation>Strg+C</translation>
    </message>
    <message>
        <source>copies the chosen message</source>
        <translation>kopiert die gewählte Meldung</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Umschalt+Tab</translation>
    </message>
    <message>
        <source>next and previous field</source>
        <translation>nächstes und voriges Feld</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>stops all robots, always and everywhere</source>
        <translation>hält alle Roboter an, immer und überall</translation>
    </message>
    <message>
        <source>Space or Return, held</source>
        <translation>Leertaste oder Eingabe, gehalten</translation>
    </message>
    <message>
        <source>on the handle beside STOP: releases the robot</source>
        <translation>auf dem Griff neben STOPP: gibt den Roboter frei</translation>
    </message>
    <message>
        <source>Click into the camera</source>
        <translation>Klick in die Kamera</translation>
    </message>
    <message>
        <source>drives with keys, as F2</source>
        <translation>fährt mit Tasten, wie F2</translation>
    </message>
    <message>
        <source>W S A D, arrows</source>
        <translation>W S A D, Pfeile</translation>
    </message>
    <message>
        <source>drive, while driving with keys; a robot&apos;s file may bind others</source>
        <translation>fahren, solange mit Tasten gefahren wird; die Datei eines Roboters kann andere belegen</translation>
    </message>
    <message>
        <source>Shift, Ctrl</source>
        <translation>Umschalt, Strg</translation>
    </message>
    <message>
        <source>while driving: a quarter of the robot&apos;s speed, all of it</source>
        <translation>beim Fahren: ein Viertel der Geschwindigkeit des Roboters, die ganze</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>while driving: halts the robot</source>
        <translation>beim Fahren: lässt den Roboter halten</translation>
    </message>
    <message>
        <source>G, held</source>
        <translation>G, gehalten</translation>
    </message>
    <message>
        <source>while driving: drives without eyes</source>
        <translation>beim Fahren: fährt ohne Sicht</translation>
    </message>
    <message>
        <source>Q E, Page Up, Page Down</source>
        <translation>Q E, Bild auf, Bild ab</translation>
    </message>
    <message>
        <source>turn the large camera while they are held, with Shift slowly</source>
        <translation>drehen die große Kamera, solange sie gehalten werden, mit Umschalt langsam</translation>
    </message>
    <message>
        <source>Number pad 4 6 8 2, 5</source>
        <translation>Ziffernblock 4 6 8 2, 5</translation>
    </message>
    <message>
        <source>turn the large camera; all cameras look ahead</source>
        <translation>drehen die große Kamera; alle Kameras sehen nach vorn</translation>
    </message>
    <message>
        <source>Dragging the large picture</source>
        <translation>Ziehen im großen Bild</translation>
    </message>
    <message>
        <source>turns its camera</source>
        <translation>dreht dessen Kamera</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Umschalt+Klick</translation>
    </message>
    <message>
        <source>into a picture or the virtual scan: files the victim that is there</source>
        <translation>in ein Bild oder den virtuellen Scan: legt das Opfer dort an</translation>
    </message>
    <message>
        <source>Double click on the floor</source>
        <translation>Doppelklick auf den Boden</translation>
    </message>
    <message>
        <source>sends the selected robot there, if it takes goals</source>
        <translation>schickt den gewählten Roboter dorthin, wenn er Ziele annimmt</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>Rechte Taste</translation>
    </message>
    <message>
        <source>while something is placed on the map: ends that, takes a corner back</source>
        <translation>solange etwas auf die Karte gesetzt wird: beendet das, nimmt eine Ecke zurück</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>in a list: acknowledges the alarm, fills in the find&apos;s form, shows what was missed</source>
        <translation>in einer Liste: quittiert den Alarm, füllt das Formular des Funds aus, zeigt, was übersehen wurde</translation>
    </message>
    <message>
        <source>Besides the commands</source>
        <translation>Neben den Befehlen</translation>
    </message>
    <message>
        <source>← →</source>
        <translation>← →</translation>
    </message>
    <message>
        <source>in the timeline: a second back, on; with Shift ten</source>
        <translation>in der Zeitleiste: eine Sekunde zurück, vor; mit Umschalt zehn</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Pos1, Ende</translation>
    </message>
    <message>
        <source>in the timeline: to the start, to the end</source>
        <translation>in der Zeitleiste: zum Anfang, zum Ende</translation>
    </message>
    <message>
        <source>in the list of finds: goes to when the chosen one was found</source>
        <translation>in der Liste der Funde: geht dorthin, wo der gewählte gefunden wurde</translation>
    </message>
    <message>
        <source>ends measuring</source>
        <translation>beendet das Messen</translation>
    </message>
</context>
<context>
    <name>leitstand::KeyScanModel</name>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Gilt</translation>
    </message>
    <message>
        <source>Doubts</source>
        <translation>Zweifel</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Entered</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>Set aside by the operator: neither shown nor used.</source>
        <translation>Vom Operator ausgeschlossen: weder gezeigt noch verwendet.</translation>
    </message>
    <message>
        <source>It fits.</source>
        <translation>Er passt.</translation>
    </message>
    <message>
        <source>Accepted by the operator.</source>
        <translation>Vom Operator angenommen.</translation>
    </message>
    <message>
        <source>Overlap %1, pairs %2 mm apart, certainty %3, matched near scan %4</source>
        <translation>Überlappung %1, Paare %2 mm auseinander, Gewissheit %3, abgeglichen nahe Scan %4</translation>
    </message>
    <message>
        <source>1 key scan</source>
        <translation>1 Schlüsselscan</translation>
    </message>
    <message>
        <source>%1 key scans</source>
        <translation>%1 Schlüsselscans</translation>
    </message>
    <message>
        <source>%1 for you to decide</source>
        <translation>%1 zu entscheiden</translation>
    </message>
</context>
<context>
    <name>leitstand::Language</name>
    <message>
        <source>The window is made again in this language</source>
        <translation>Das Fenster wird in dieser Sprache neu aufgebaut</translation>
    </message>
</context>
<context>
    <name>leitstand::LayoutFeature</name>
    <message>
        <source>S&amp;wap camera and map</source>
        <translation>Kamera und Karte ta&amp;uschen</translation>
    </message>
    <message>
        <source>Camera and map change places</source>
        <translation>Kamera und Karte tauschen die Plätze</translation>
    </message>
    <message>
        <source>&amp;Arrange panes</source>
        <translation>Teilfenster a&amp;nordnen</translation>
    </message>
    <message>
        <source>Panes get titles to be dragged by, to another place or out of the window; again to hold them there</source>
        <translation>Teilfenster erhalten Titel, an denen sie sich verschieben oder aus dem Fenster ziehen lassen; noch einmal hält sie dort fest</translation>
    </message>
    <message>
        <source>Save la&amp;yout as…</source>
        <translation>La&amp;yout speichern als…</translation>
    </message>
    <message>
        <source>Keeps how panes are now as a layout of one&apos;s own</source>
        <translation>Behält die jetzige Anordnung der Teilfenster als eigenes Layout</translation>
    </message>
    <message>
        <source>&amp;Delete this layout</source>
        <translation>Dieses Layout lös&amp;chen</translation>
    </message>
    <message>
        <source>Deletes the file of a layout of one&apos;s own</source>
        <translation>Löscht die Datei eines eigenen Layouts</translation>
    </message>
    <message>
        <source>&amp;Panes</source>
        <translation>Teil&amp;fenster</translation>
    </message>
    <message>
        <source>Layout %1</source>
        <translation>Layout %1</translation>
    </message>
    <message>
        <source>layout %1 binds keys to what is no command: %2</source>
        <translation>Layout %1 belegt Tasten mit etwas, das kein Befehl ist: %2</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>Layout speichern</translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation>Name des Layouts</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>Explore</source>
        <translation>Erkunden</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Funk</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>layout %1 binds keys that are none, or that mean something else: %2</source>
        <translation>Layout %1 belegt Tasten, die es nicht gibt oder die etwas anderes bedeuten: %2</translation>
    </message>
</context>
<context>
    <name>leitstand::LayoutSwitch</name>
    <message>
        <source>Layout</source>
        <translation>Layout</translation>
    </message>
    <message>
        <source>Layout %1</source>
        <translation>Layout %1</translation>
    </message>
    <message>
        <source>Layout %1; a click shows the others</source>
        <translation>Layout %1; ein Klick zeigt die anderen</translation>
    </message>
</context>
<context>
    <name>leitstand::LinkFeature</name>
    <message>
        <source>&amp;Thin link</source>
        <translation>&amp;Funk sparen</translation>
    </message>
    <message>
        <source>Asks robots for less, so that what matters comes: commands and stop, telemetry, scans, one camera, the rest</source>
        <translation>Verlangt weniger von den Robotern, damit das Wichtige ankommt: Befehle und STOP, Telemetrie, Scans, eine Kamera, der Rest</translation>
    </message>
    <message>
        <source>THIN LINK (T)</source>
        <translation>SPARFUNK (T)</translation>
    </message>
    <message>
        <source>Robots are asked for less: other cameras come rarely or not at all</source>
        <translation>Von den Robotern wird weniger verlangt: andere Kameras kommen selten oder gar nicht</translation>
    </message>
    <message>
        <source>Thin link: telemetry, scans and one camera come first (T ends it)</source>
        <translation>Sparfunk: Telemetrie, Scans und eine Kamera kommen zuerst (T beendet ihn)</translation>
    </message>
    <message>
        <source>The link is not thin any more: everything as robots like</source>
        <translation>Sparfunk beendet: alles nach Wahl der Roboter</translation>
    </message>
</context>
<context>
    <name>leitstand::LinkPane</name>
    <message>
        <source>Sent</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Whether the robot sends this stream at all</source>
        <translation>Ob der Roboter diesen Datenstrom überhaupt sendet</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Samples a second, at most; 0: as the robot likes</source>
        <translation>Höchstzahl der Werte je Sekunde; 0: nach Wahl des Roboters</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Of JPEG pictures, 1 to 100; 0: as the robot likes</source>
        <translation>Von JPEG-Bildern, 1 bis 100; 0: nach Wahl des Roboters</translation>
    </message>
    <message>
        <source>Width px</source>
        <translation>Breite px</translation>
    </message>
    <message>
        <source>Wider pictures are made smaller; 0: as the robot likes</source>
        <translation>Breitere Bilder werden verkleinert; 0: nach Wahl des Roboters</translation>
    </message>
    <message>
        <source>What all streams of all robots take of the link</source>
        <translation>Was alle Datenströme aller Roboter vom Funk beanspruchen</translation>
    </message>
    <message>
        <source>Mbit/s</source>
        <translation>Mbit/s</translation>
    </message>
    <message>
        <source>What a thin link has room for, all robots together</source>
        <translation>Wofür im Sparfunk Platz ist, alle Roboter zusammen</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>Funk %1</translation>
    </message>
    <message>
        <source>Choose a stream</source>
        <translation>Datenstrom wählen</translation>
    </message>
    <message>
        <source>%1: not settable</source>
        <translation>%1: nicht einstellbar</translation>
    </message>
    <message>
        <source>Makes the map</source>
        <translation>Macht die Karte</translation>
    </message>
    <message>
        <source>Whether the map is made from this cloud; the robot&apos;s others are shown, and used for obstacles</source>
        <translation>Ob die Karte aus dieser Punktwolke entsteht; die anderen des Roboters werden gezeigt und für Hindernisse genutzt</translation>
    </message>
</context>
<context>
    <name>leitstand::LinkStatus</name>
    <message>
        <source>3D scans</source>
        <translation>3D-Scans</translation>
    </message>
    <message>
        <source>laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>odometry</source>
        <translation>Odometrie</translation>
    </message>
    <message>
        <source>attitude</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>transforms</source>
        <translation>Transformationen</translation>
    </message>
    <message>
        <source>pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>camera data</source>
        <translation>Kameradaten</translation>
    </message>
    <message>
        <source>infrared</source>
        <translation>Infrarot</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>diagnostics</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>not heard yet</source>
        <translation>noch nicht gehört</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>degraded</source>
        <translation>gestört</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>silent for %1</source>
        <translation>still seit %1</translation>
    </message>
    <message>
        <source>%1 %2 old</source>
        <translation>%1 %2 alt</translation>
    </message>
    <message>
        <source>%1 %2 late</source>
        <translation>%1 %2 zu spät</translation>
    </message>
    <message>
        <source>%1 of %2 lost</source>
        <translation>%1 verloren: %2</translation>
    </message>
    <message>
        <source>slow: %1</source>
        <translation>langsam: %1</translation>
    </message>
    <message>
        <source>no answer for %1</source>
        <translation>keine Antwort seit %1</translation>
    </message>
    <message>
        <source>%1 loss</source>
        <translation>%1 Verlust</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>sightings</source>
        <translation>Sichtungen</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>left</source>
        <comment>a camera</comment>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <comment>a camera</comment>
        <translation>rechts</translation>
    </message>
    <message>
        <source>panorama</source>
        <comment>a camera</comment>
        <translation>Panorama</translation>
    </message>
    <message>
        <source>infrared</source>
        <comment>a camera</comment>
        <translation>Infrarot</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>a camera and what it sends: left pictures</comment>
        <translation>%2 %1</translation>
    </message>
    <message>
        <source>fixed transforms</source>
        <translation>feste Transformationen</translation>
    </message>
    <message>
        <source>its own map</source>
        <translation>eigene Karte</translation>
    </message>
    <message>
        <source>changes of its map</source>
        <translation>Änderungen seiner Karte</translation>
    </message>
    <message>
        <source>its planned path</source>
        <translation>geplanter Weg</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>what it draws</source>
        <translation>was er zeichnet</translation>
    </message>
    <message>
        <source>its model</source>
        <translation>sein Modell</translation>
    </message>
    <message>
        <source>what it sees in pictures</source>
        <translation>was er in Bildern erkennt</translation>
    </message>
</context>
<context>
    <name>leitstand::LinksOnMap</name>
    <message>
        <source>Where the map meets &amp;itself</source>
        <translation>Wo die Karte sich selbst tr&amp;ifft</translation>
    </message>
    <message>
        <source>Lines between scans that see the same place: solid where the map follows them, dashed where it was asked or they were taken back, dotted where somebody said no</source>
        <translation>Linien zwischen Scans, die denselben Ort sehen: durchgezogen, wo die Karte ihnen folgt, gestrichelt, wo gefragt wurde oder sie zurückgenommen sind, gepunktet, wo jemand Nein sagte</translation>
    </message>
</context>
<context>
    <name>leitstand::LiveSummary</name>
    <message>
        <source>last scan %1 s ago</source>
        <translation>Scan vor %1 s</translation>
    </message>
    <message>
        <source>last scan %1 min ago</source>
        <translation>Scan vor %1 min</translation>
    </message>
    <message>
        <source>3D map</source>
        <translation>3D-Karte</translation>
    </message>
    <message>
        <source>1 key scan</source>
        <translation>1 Schlüsselscan</translation>
    </message>
    <message>
        <source>%1 key scans</source>
        <translation>%1 Schlüsselscans</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>follows %1</source>
        <translation>folgt %1</translation>
    </message>
    <message>
        <source>overlap %1</source>
        <translation>Überlappung %1</translation>
    </message>
    <message>
        <source>made by %1</source>
        <translation>gemacht von %1</translation>
    </message>
    <message>
        <source>The newest key scan: whether it is certain, and how much of it meets the map; and how long ago any scan was laid onto the map</source>
        <translation>Der neueste Schlüsselscan: ob er sicher ist und wie viel von ihm die Karte trifft; und vor wie langer Zeit irgendein Scan auf die Karte gelegt wurde</translation>
    </message>
</context>
<context>
    <name>leitstand::LiveWindow</name>
    <message>
        <source>Leitstand</source>
        <translation>Leitstand</translation>
    </message>
    <message>
        <source>%1 is not connected</source>
        <translation>%1 ist nicht verbunden</translation>
    </message>
</context>
<context>
    <name>leitstand::LogSays</name>
    <message>
        <source>the disk is full in {} minutes at {} MB/s</source>
        <translation>der Datenträger ist in {} Minuten voll, bei {} MB/s</translation>
    </message>
    <message>
        <source>the disk lasts {} minutes again</source>
        <translation>der Datenträger reicht wieder für {} Minuten</translation>
    </message>
    <message>
        <source>the disk lasts for days again</source>
        <translation>der Datenträger reicht wieder für Tage</translation>
    </message>
    <message>
        <source>the disk is full; {} MB wait in memory</source>
        <translation>der Datenträger ist voll; {} MB warten im Speicher</translation>
    </message>
    <message>
        <source>there is space on the disk again</source>
        <translation>auf dem Datenträger ist wieder Platz</translation>
    </message>
    <message>
        <source>the disk does not keep up: {} s behind, {} MB wait, {} pictures dropped</source>
        <translation>der Datenträger kommt nicht nach: {} s zurück, {} MB warten, {} Bilder verworfen</translation>
    </message>
    <message>
        <source>the disk keeps up again; {} pictures were dropped</source>
        <translation>der Datenträger kommt wieder nach; {} Bilder wurden verworfen</translation>
    </message>
    <message>
        <source>{} events that are no pictures are lost</source>
        <translation>{} Ereignisse, die keine Bilder sind, sind verloren</translation>
    </message>
    <message>
        <source>no more events are lost; {} were</source>
        <translation>es gehen keine Ereignisse mehr verloren; {} gingen verloren</translation>
    </message>
    <message>
        <source>is written again</source>
        <translation>wird wieder geschrieben</translation>
    </message>
</context>
<context>
    <name>leitstand::LookBar</name>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Edge of the voxels</source>
        <translation>Kantenlänge der Voxel</translation>
    </message>
    <message>
        <source>Heights above the first scan&apos;s scanner, in its frame</source>
        <translation>Höhen über dem Scanner des ersten Scans, in dessen Koordinatensystem</translation>
    </message>
    <message>
        <source>Heights from</source>
        <translation>Höhen von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
</context>
<context>
    <name>leitstand::LoopNotice</name>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>The loop stays closed; the menu Map opens it later, too</source>
        <translation>Die Schleife bleibt geschlossen; das Menü „Karte“ öffnet sie auch später</translation>
    </message>
    <message>
        <source>The map met itself and closed the loop: scans moved by up to %1 m.</source>
        <translation>Die Karte ist auf sich selbst getroffen, die Schleife ist geschlossen: Scans haben sich um bis zu %1 m verschoben.</translation>
    </message>
</context>
<context>
    <name>leitstand::LoopsFeature</name>
    <message>
        <source>It is the same place: c&amp;lose the loop</source>
        <translation>Es ist dieselbe Stelle: Sch&amp;leife schließen</translation>
    </message>
    <message>
        <source>It is &amp;another place</source>
        <translation>Es ist eine &amp;andere Stelle</translation>
    </message>
    <message>
        <source>Take back the cl&amp;osed loop</source>
        <translation>Geschl&amp;ossene Schleife zurücknehmen</translation>
    </message>
    <message>
        <source>Same place</source>
        <translation>Dieselbe Stelle</translation>
    </message>
    <message>
        <source>Another place</source>
        <translation>Andere Stelle</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>Schleife öffnen</translation>
    </message>
    <message>
        <source>The scans that see it are put together, and all others follow</source>
        <translation>Die Scans, die sie sehen, werden zusammengefügt, und alle anderen folgen</translation>
    </message>
    <message>
        <source>The map stays as it is, and is not asked about there again</source>
        <translation>Die Karte bleibt, wie sie ist, und dort wird nicht wieder gefragt</translation>
    </message>
    <message>
        <source>The newest place where the map met itself comes apart again: scans go back to where they were, and it does not close there by itself</source>
        <translation>Die jüngste Stelle, an der die Karte sich selbst traf, geht wieder auseinander: Scans kehren dorthin zurück, wo sie waren, und dort schließt sich von selbst nichts mehr</translation>
    </message>
    <message>
        <source>No loop closed in the map</source>
        <translation>In der Karte hat sich keine Schleife geschlossen</translation>
    </message>
    <message>
        <source>Nothing is asked about the map</source>
        <translation>Zur Karte ist nichts gefragt</translation>
    </message>
    <message>
        <source>Is this a place that was seen before? The map is %1 off here, more than expected.</source>
        <translation>Wurde diese Stelle schon einmal gesehen? Die Karte liegt hier um %1 daneben, mehr als erwartet.</translation>
    </message>
    <message>
        <source>Violet: the map if it is. Scans moved: %1, by up to %2.</source>
        <translation>Violett: die Karte, wenn ja. Bewegte Scans: %1, um bis zu %2.</translation>
    </message>
    <message>
        <source>Finds moved: %1.</source>
        <translation>Bewegte Funde: %1.</translation>
    </message>
    <message>
        <source>If it is, no scan moves.</source>
        <translation>Wenn ja, bewegt sich kein Scan.</translation>
    </message>
    <message>
        <source>Links of other loops that speak against it: %1.</source>
        <translation>Verbindungen anderer Schleifen, die widersprechen: %1.</translation>
    </message>
    <message>
        <source>Did these two parts of the map see the same place?</source>
        <translation>Haben diese beiden Teile der Karte denselben Ort gesehen?</translation>
    </message>
    <message>
        <source>Map of %1, not joined yet</source>
        <translation>Karte von %1, noch nicht verbunden</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
</context>
<context>
    <name>leitstand::MainWindow</name>
    <message>
        <source>Leitstand</source>
        <translation>Leitstand</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Registration</source>
        <translation>&amp;Registrierung</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Click two points of the map · Esc ends measuring</source>
        <translation>Zwei Punkte der Karte anklicken · Esc beendet das Messen</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>%1 scans are registered</source>
        <translation>%1 Scans registriert</translation>
    </message>
    <message>
        <source>no picture: after %1 s only %2, others are not</source>
        <translation>kein Bild: nach %1 s nur %2, andere nicht</translation>
    </message>
    <message>
        <source>no picture: %1, but they are not drawn after %2 s</source>
        <translation>kein Bild: %1, aber nach %2 s nicht gezeichnet</translation>
    </message>
    <message>
        <source>%1: the picture could not be written</source>
        <translation>%1: das Bild konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Shows or hides the messages (F4)</source>
        <translation>Zeigt oder verbirgt die Meldungen (F4)</translation>
    </message>
</context>
<context>
    <name>leitstand::MapFeature</name>
    <message>
        <source>no scan is registered and drawn</source>
        <translation>kein Scan ist registriert und gezeichnet</translation>
    </message>
</context>
<context>
    <name>leitstand::MapGrantFeature</name>
    <message>
        <source>Hand the map over</source>
        <translation>Karte übergeben</translation>
    </message>
    <message>
        <source>Another station registers the scans from now on, and decides on them; this one goes on showing its map</source>
        <translation>Eine andere Station registriert von jetzt an die Scans und entscheidet über sie; diese zeigt weiter deren Karte</translation>
    </message>
    <message>
        <source>Hand the map over to %1</source>
        <translation>Karte an %1 übergeben</translation>
    </message>
    <message>
        <source>%1 makes the map: it is shown here, and decided on there</source>
        <translation>%1 macht die Karte: sie wird hier gezeigt, entschieden wird dort</translation>
    </message>
    <message>
        <source>The map is made here</source>
        <translation>Die Karte wird hier gemacht</translation>
    </message>
</context>
<context>
    <name>leitstand::MapPane</name>
    <message>
        <source>3D map</source>
        <translation>3D-Karte</translation>
    </message>
    <message>
        <source>Drop scans, a folder of scans or a mission here,
or choose File ▸ Open scans (Ctrl+O) or Open folder (Ctrl+Shift+O)

F1 lists all keys</source>
        <translation>Scans, einen Ordner mit Scans oder eine Mission hier ablegen
oder Datei ▸ Scans öffnen (Strg+O) oder Ordner öffnen (Strg+Umschalt+O) wählen

F1 listet alle Tasten</translation>
    </message>
</context>
<context>
    <name>leitstand::MapReadout</name>
    <message>
        <source>floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>Decke</translation>
    </message>
    <message>
        <source>unlabelled</source>
        <translation>ohne Label</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3 m · %4 · %5</source>
        <translation>x %1  y %2  z %3 m · %4 · %5</translation>
    </message>
    <message>
        <source>%1 m · dx %2 m  dy %3 m  dz %4 m</source>
        <translation>%1 m · dx %2 m  dy %3 m  dz %4 m</translation>
    </message>
</context>
<context>
    <name>leitstand::MapScenery</name>
    <message>
        <source>The map cannot be drawn: %1</source>
        <translation>Die Karte kann nicht gezeichnet werden: %1</translation>
    </message>
</context>
<context>
    <name>leitstand::MapSummary</name>
    <message>
        <source>3D map</source>
        <translation>3D-Karte</translation>
    </message>
    <message>
        <source>3D map · 1 scan · %1 points</source>
        <translation>3D-Karte · 1 Scan · %1 Punkte</translation>
    </message>
    <message>
        <source>3D map · %1 scans · %2 points</source>
        <translation>3D-Karte · %1 Scans · %2 Punkte</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 scans %2</source>
        <translation>%1 Scans %2</translation>
    </message>
    <message>
        <source>registered in %1 s · overlap %2 · %3</source>
        <translation>registriert in %1 s · Überlappung %2 · %3</translation>
    </message>
    <message>
        <source>Time of all registrations, and the lowest overlap of all scans</source>
        <translation>Zeit aller Registrierungen und die geringste Überlappung aller Scans</translation>
    </message>
</context>
<context>
    <name>leitstand::MapView</name>
    <message>
        <source>3D map</source>
        <translation>3D-Karte</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>Decke</translation>
    </message>
    <message>
        <source>unlabelled</source>
        <translation>ohne Label</translation>
    </message>
    <message>
        <source>uncertain ?</source>
        <translation>unsicher ?</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Entfernung</translation>
    </message>
    <message>
        <source>%1 m  dx %2 m dy %3 m dz %4 m</source>
        <comment>length of a measurement and its parts along the map&apos;s axes</comment>
        <translation>%1 m  dx %2 m dy %3 m dz %4 m</translation>
    </message>
    <message>
        <source>scan %1</source>
        <translation>Scan %1</translation>
    </message>
    <message>
        <source>%1 m grid</source>
        <translation>Raster %1 m</translation>
    </message>
    <message>
        <source>seen by camera</source>
        <translation>von Kamera gesehen</translation>
    </message>
    <message>
        <source>missed by camera</source>
        <translation>von Kamera übersehen</translation>
    </message>
    <message>
        <source>seen by infrared</source>
        <translation>von Infrarot gesehen</translation>
    </message>
    <message>
        <source>missed by infrared</source>
        <translation>von Infrarot übersehen</translation>
    </message>
    <message>
        <source>seen by scanner</source>
        <translation>vom Scanner gesehen</translation>
    </message>
    <message>
        <source>missed by scanner</source>
        <translation>vom Scanner übersehen</translation>
    </message>
    <message>
        <source>no robot named</source>
        <translation>kein Roboter genannt</translation>
    </message>
    <message>
        <source>no intensities in the data</source>
        <translation>keine Intensitäten bekannt</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>low</source>
        <translation>niedrig</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>first</source>
        <translation>erster</translation>
    </message>
    <message>
        <source>last</source>
        <translation>letzter</translation>
    </message>
    <message>
        <source>age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>if it is one place</source>
        <comment>where scans would come to stand</comment>
        <translation>wenn es eine Stelle ist</translation>
    </message>
    <message>
        <source>new</source>
        <comment>what came to a place</comment>
        <translation>neu</translation>
    </message>
    <message>
        <source>gone</source>
        <comment>what was taken away</comment>
        <translation>weg</translation>
    </message>
    <message>
        <source>moved by hand</source>
        <translation>von Hand geschoben</translation>
    </message>
    <message>
        <source>occupied</source>
        <translation>belegt</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
</context>
<context>
    <name>leitstand::MeasuresDrawing</name>
    <message>
        <source>The robot from above and from its right side</source>
        <translation>Der Roboter von oben und von rechts</translation>
    </message>
    <message>
        <source>%1 m long, %2 m wide, %3 m high</source>
        <translation>%1 m lang, %2 m breit, %3 m hoch</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>from the right</source>
        <translation>von rechts</translation>
    </message>
</context>
<context>
    <name>leitstand::MeasuresFeature</name>
    <message>
        <source>Si&amp;ze and sensors...</source>
        <translation>&amp;Größe und Sensoren...</translation>
    </message>
    <message>
        <source>How large the selected robot is and where its sensors sit, with a drawing; from its model, or measured</source>
        <translation>Wie groß der gewählte Roboter ist und wo seine Sensoren sitzen, mit Zeichnung; aus seinem Modell oder gemessen</translation>
    </message>
    <message>
        <source>Size and sensors of %1</source>
        <translation>Größe und Sensoren von %1</translation>
    </message>
    <message>
        <source>A robot is being driven: the station would open again</source>
        <translation>Ein Roboter wird gefahren: Der Leitstand würde neu öffnen</translation>
    </message>
</context>
<context>
    <name>leitstand::MeasuresForm</name>
    <message>
        <source>Sensors in the robot&apos;s base frame</source>
        <translation>Sensoren im Basissystem des Roboters</translation>
    </message>
    <message>
        <source>Where the robot tells a place by itself (tf_static), that one counts.</source>
        <translation>Wo der Roboter einen Ort selbst nennt (tf_static), gilt dieser.</translation>
    </message>
    <message>
        <source>Ahead</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Behind</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>From the base frame to the front end</source>
        <translation>Vom Basissystem bis zum vorderen Ende</translation>
    </message>
    <message>
        <source>From the base frame to the rear end</source>
        <translation>Vom Basissystem bis zum hinteren Ende</translation>
    </message>
    <message>
        <source>From the base frame to the left side</source>
        <translation>Vom Basissystem bis zur linken Seite</translation>
    </message>
    <message>
        <source>From the base frame to the right side</source>
        <translation>Vom Basissystem bis zur rechten Seite</translation>
    </message>
    <message>
        <source>From the ground to the highest part</source>
        <translation>Vom Boden bis zum höchsten Teil</translation>
    </message>
    <message>
        <source>Take from its model</source>
        <translation>Aus seinem Modell</translation>
    </message>
    <message>
        <source>Save and use</source>
        <translation>Speichern und verwenden</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Outline, height and sensor places as in the model that the robot publishes, all joints at rest</source>
        <translation>Umriss, Höhe und Orte der Sensoren wie im Modell, das der Roboter veröffentlicht, alle Gelenke in Ruhe</translation>
    </message>
    <message>
        <source>The robot publishes no model (robot_description), or it was not read yet</source>
        <translation>Der Roboter veröffentlicht kein Modell (robot_description), oder es ist noch nicht gelesen</translation>
    </message>
    <message>
        <source>Writes the robot&apos;s file; the station opens again with it and goes on with its mission</source>
        <translation>Schreibt die Datei des Roboters; der Leitstand öffnet neu mit ihr und setzt seine Mission fort</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>System %1</translation>
    </message>
    <message>
        <source>The outline has %1 corners; a number that is changed here makes it a rectangle.</source>
        <translation>Der Umriss hat %1 Ecken; eine Zahl, die hier geändert wird, macht ihn zum Rechteck.</translation>
    </message>
</context>
<context>
    <name>leitstand::MenuCorner</name>
    <message>
        <source>Newest message</source>
        <translation>Neueste Meldung</translation>
    </message>
</context>
<context>
    <name>leitstand::MergeWords</name>
    <message>
        <source>There is no other find of this kind to merge it with</source>
        <translation>Es gibt keinen anderen Fund dieser Art zum Vereinen</translation>
    </message>
    <message>
        <source>%1, the nearest to %2, is %3 m away from it: move one of them there first</source>
        <translation>%1, der nächste Fund bei %2, ist %3 m davon entfernt: erst einen von beiden dorthin verschieben</translation>
    </message>
    <message>
        <source>%1 is part of %2 now, %3 m away</source>
        <translation>%1 ist jetzt Teil von %2 (%3 m entfernt)</translation>
    </message>
</context>
<context>
    <name>leitstand::MessageListModel</name>
    <message>
        <source>▲ Error  %1  %2</source>
        <translation>▲ Fehler  %1  %2</translation>
    </message>
    <message>
        <source>Note  %1  %2</source>
        <translation>Hinweis  %1  %2</translation>
    </message>
</context>
<context>
    <name>leitstand::MessagesFeature</name>
    <message>
        <source>Me&amp;ssages</source>
        <translation>Mel&amp;dungen</translation>
    </message>
    <message>
        <source>All messages so far, the newest last</source>
        <translation>Was bisher gemeldet wurde, das Neueste zuletzt</translation>
    </message>
</context>
<context>
    <name>leitstand::MessagesPanel</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes the chosen message away (Del)</source>
        <translation>Entfernt die gewählte Meldung (Entf)</translation>
    </message>
    <message>
        <source>Dismiss all</source>
        <translation>Alle entfernen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Takes the chosen message away</source>
        <translation>Nimmt die gewählte Meldung weg</translation>
    </message>
</context>
<context>
    <name>leitstand::MissedModel</name>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>x %1, y %2</source>
        <translation>x %1, y %2</translation>
    </message>
    <message>
        <source>No floor is known yet</source>
        <translation>Noch ist kein Boden bekannt</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Übersehen</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>In the map</source>
        <translation>In der Karte</translation>
    </message>
    <message>
        <source>%1: %2 of %3 m² seen, places missed: %4</source>
        <translation>%1: %2 von %3 m² gesehen, übersehene Stellen: %4</translation>
    </message>
    <message>
        <source>What was searched is not known yet</source>
        <translation>Was abgesucht ist, ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>Only small pieces were missed</source>
        <translation>Nur kleine Stücke wurden übersehen</translation>
    </message>
    <message>
        <source>Nothing that can be reached was missed</source>
        <translation>Nichts Erreichbares wurde übersehen</translation>
    </message>
    <message>
        <source>x %1, y %2, storey %3</source>
        <translation>x %1, y %2, Stockwerk %3</translation>
    </message>
    <message>
        <source>; storey %1: %2</source>
        <translation>; Stockwerk %1: %2</translation>
    </message>
</context>
<context>
    <name>leitstand::MissedPanel</name>
    <message>
        <source>What was missed</source>
        <translation>Was übersehen wurde</translation>
    </message>
    <message>
        <source>Searched with</source>
        <translation>Abgesucht mit</translation>
    </message>
    <message>
        <source>With which sensor the floor counts as searched</source>
        <translation>Mit welchem Sensor der Boden als abgesucht gilt</translation>
    </message>
    <message>
        <source>Floor that was missed, the largest piece first</source>
        <translation>Übersehener Boden, das größte Stück zuerst</translation>
    </message>
</context>
<context>
    <name>leitstand::MissionFeature</name>
    <message>
        <source>&amp;Clock runs</source>
        <translation>&amp;Uhr läuft</translation>
    </message>
    <message>
        <source>Lets the mission&apos;s clock go, or holds it</source>
        <translation>Lässt die Missionsuhr laufen oder hält sie an</translation>
    </message>
    <message>
        <source>&amp;Length of the mission…</source>
        <translation>&amp;Dauer der Mission…</translation>
    </message>
    <message>
        <source>How long the mission may last: the clock counts down from it</source>
        <translation>Wie lange die Mission dauern darf: die Uhr zählt von da herunter</translation>
    </message>
    <message>
        <source>Clock to &amp;zero</source>
        <translation>Uhr auf Nu&amp;ll</translation>
    </message>
    <message>
        <source>The mission begins now</source>
        <translation>Die Mission beginnt jetzt</translation>
    </message>
    <message>
        <source>Length of the mission</source>
        <translation>Dauer der Mission</translation>
    </message>
    <message>
        <source>Minutes; 0: without end</source>
        <translation>Minuten; 0: ohne Ende</translation>
    </message>
    <message>
        <source>&amp;Go on with the mission before</source>
        <translation>Vorherige Mission &amp;fortsetzen</translation>
    </message>
    <message>
        <source>Ends this mission, and goes on with the one that was recorded until shortly before it: map, finds, clock</source>
        <translation>Beendet diese Mission und setzt die fort, die bis kurz davor aufgezeichnet wurde: Karte, Funde, Uhr</translation>
    </message>
    <message>
        <source>The mission before</source>
        <translation>Vorherige Mission</translation>
    </message>
    <message>
        <source>End this mission and go on with %1?</source>
        <translation>Diese Mission beenden und %1 fortsetzen?</translation>
    </message>
    <message>
        <source>Robots stop for some seconds. This mission is kept.</source>
        <translation>Die Roboter halten für einige Sekunden an. Diese Mission bleibt erhalten.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Hier bleiben</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>A &amp;new mission in the map of…</source>
        <translation>Eine &amp;neue Mission in der Karte von …</translation>
    </message>
    <message>
        <source>Ends this mission, and begins a new one that goes on in its map, or in that of an earlier one; robots find their place in it as they drive</source>
        <translation>Beendet diese Mission und beginnt eine neue, die in ihrer Karte oder in der einer früheren weitergeht; Roboter finden ihren Ort darin, während sie fahren</translation>
    </message>
    <message>
        <source>A new mission in the map of…</source>
        <translation>Eine neue Mission in der Karte von …</translation>
    </message>
    <message>
        <source>A new mission</source>
        <translation>Eine neue Mission</translation>
    </message>
    <message>
        <source>End this mission and begin a new one in the map of %1?</source>
        <translation>Diese Mission beenden und eine neue in der Karte von %1 beginnen?</translation>
    </message>
    <message>
        <source>Begin it</source>
        <translation>Beginnen</translation>
    </message>
</context>
<context>
    <name>leitstand::MissionForm</name>
    <message>
        <source>Mission data</source>
        <translation>Missionsdaten</translation>
    </message>
    <message>
        <source>Competition</source>
        <translation>Wettbewerb</translation>
    </message>
    <message>
        <source>RoboCup2026</source>
        <translation>RoboCup2026</translation>
    </message>
    <message>
        <source>Team</source>
        <translation>Team</translation>
    </message>
    <message>
        <source>Country</source>
        <translation>Land</translation>
    </message>
    <message>
        <source>Mission</source>
        <translation>Mission</translation>
    </message>
    <message>
        <source>Preliminary1</source>
        <translation>Vorrunde1</translation>
    </message>
    <message>
        <source>Operators</source>
        <translation>Operatoren</translation>
    </message>
    <message>
        <source>People who drive; some rules divide the score by them</source>
        <translation>Personen, die fahren; manche Regeln teilen die Punkte durch ihre Zahl</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Of finds that say nothing else</source>
        <translation>Für Funde, bei denen nichts anderes steht</translation>
    </message>
    <message>
        <source>Rules of the score</source>
        <translation>Regeln der Wertung</translation>
    </message>
    <message>
        <source>Names of the report&apos;s files begin with it</source>
        <translation>Damit beginnen die Namen der Dateien des Berichts</translation>
    </message>
    <message>
        <source>As it was registered; in all lists of the report</source>
        <translation>Wie angemeldet; in allen Listen des Berichts</translation>
    </message>
    <message>
        <source>Of the team; in all lists of the report</source>
        <translation>Des Teams; in allen Listen des Berichts</translation>
    </message>
    <message>
        <source>Which run of the competition it is</source>
        <translation>Welcher Lauf des Wettbewerbs es ist</translation>
    </message>
    <message>
        <source>By these the score is estimated, here and in the report</source>
        <translation>Danach wird die Wertung geschätzt, hier und im Bericht</translation>
    </message>
</context>
<context>
    <name>leitstand::ModeCell</name>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Refuses: this station goes on driving</source>
        <translation>Lehnt ab: diese Station fährt weiter</translation>
    </message>
    <message>
        <source>Mode of %1</source>
        <translation>Modus von %1</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Anfordern</translation>
    </message>
    <message>
        <source>Requests drive control of this robot</source>
        <translation>Fordert das Fahrrecht für diesen Roboter an</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbruch</translation>
    </message>
    <message>
        <source>Withdraws the request</source>
        <translation>Zieht die Anforderung zurück</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>Releases drive control: others may take it</source>
        <translation>Gibt das Fahrrecht ab: andere können es übernehmen</translation>
    </message>
    <message>
        <source>Give</source>
        <translation>Geben</translation>
    </message>
    <message>
        <source>Consents: the other station drives</source>
        <translation>Stimmt zu: die andere Station fährt</translation>
    </message>
    <message>
        <source>%1 mode</source>
        <translation>Modus %1</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>Nächstes</translation>
    </message>
</context>
<context>
    <name>leitstand::ModeLabel</name>
    <message>
        <source>TELEOPERATION</source>
        <translation>TELEOPERATION</translation>
    </message>
    <message>
        <source>MODE UNKNOWN</source>
        <translation>MODUS UNBEKANNT</translation>
    </message>
    <message>
        <source>the robot tells none</source>
        <translation>der Roboter meldet keinen</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>teleoperation</source>
        <translation>Teleoperation</translation>
    </message>
    <message>
        <source>safe teleoperation</source>
        <translation>sichere Teleoperation</translation>
    </message>
    <message>
        <source>explore</source>
        <translation>Erkundung</translation>
    </message>
    <message>
        <source>victim approach</source>
        <translation>Opferanfahrt</translation>
    </message>
    <message>
        <source>radio remote</source>
        <translation>Handsender</translation>
    </message>
    <message>
        <source>NOT HEARD YET</source>
        <translation>NOCH NICHT GEHÖRT</translation>
    </message>
    <message>
        <source>waits for the robot</source>
        <translation>wartet auf den Roboter</translation>
    </message>
    <message>
        <source>silent for %1 · was in %2</source>
        <translation>still seit %1 · zuletzt %2</translation>
    </message>
    <message>
        <source>silent for %1</source>
        <translation>still seit %1</translation>
    </message>
    <message>
        <source>LINK LOST</source>
        <translation>FUNK VERLOREN</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>%1 · OVERRIDE</source>
        <translation>%1 · ÜBERBRÜCKT</translation>
    </message>
    <message>
        <source>teleop</source>
        <translation>Teleop</translation>
    </message>
    <message>
        <source>safe teleop</source>
        <translation>sichere Teleop</translation>
    </message>
    <message>
        <source>approach</source>
        <translation>Anfahrt</translation>
    </message>
    <message>
        <source>remote</source>
        <translation>Handsender</translation>
    </message>
    <message>
        <source>NO MODES</source>
        <translation>KEINE MODI</translation>
    </message>
    <message>
        <source>others may drive it, too</source>
        <translation>auch andere können ihn fahren</translation>
    </message>
    <message>
        <source>TO ITS GOAL</source>
        <translation>ZUM ZIEL</translation>
    </message>
    <message>
        <source>GOAL</source>
        <translation>ZIEL</translation>
    </message>
</context>
<context>
    <name>leitstand::MoreRobotsButton</name>
    <message>
        <source>Robots to the left</source>
        <translation>Roboter weiter links</translation>
    </message>
    <message>
        <source>Robots to the right</source>
        <translation>Roboter weiter rechts</translation>
    </message>
    <message>
        <source>Robots out of sight: %1</source>
        <translation>Roboter außer Sicht: %1</translation>
    </message>
</context>
<context>
    <name>leitstand::PadCallouts</name>
    <message>
        <source>drive</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>Seitwärts</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Left stick</source>
        <translation>Linker Stick</translation>
    </message>
    <message>
        <source>Right stick</source>
        <translation>Rechter Stick</translation>
    </message>
</context>
<context>
    <name>leitstand::PadFeature</name>
    <message>
        <source>Select the &amp;next robot</source>
        <translation>&amp;Nächsten Roboter wählen</translation>
    </message>
    <message>
        <source>Selects the next robot, after the last one the first</source>
        <translation>Wählt den nächsten Roboter, nach dem letzten den ersten</translation>
    </message>
    <message>
        <source>&amp;Gamepad …</source>
        <translation>&amp;Gamepad …</translation>
    </message>
    <message>
        <source>Which gamepad drives, and what its controls do</source>
        <translation>Welches Gamepad fährt und was seine Bedienelemente bewirken</translation>
    </message>
    <message>
        <source>&amp;Controls of the gamepad</source>
        <translation>Belegung des Game&amp;pads</translation>
    </message>
    <message>
        <source>Shows what each control of the gamepad does</source>
        <translation>Zeigt, was jedes Bedienelement des Gamepads bewirkt</translation>
    </message>
    <message>
        <source>%1 is plugged in; H shows its controls.</source>
        <translation>%1 ist angeschlossen; H zeigt die Belegung.</translation>
    </message>
    <message>
        <source>%1 is unplugged.</source>
        <translation>%1 ist abgezogen.</translation>
    </message>
    <message>
        <source>Let the sticks go first, and the trigger too if that is not enough.</source>
        <translation>Erst die Sticks loslassen, und auch die Totmanntaste, wenn das nicht genügt.</translation>
    </message>
</context>
<context>
    <name>leitstand::PadInput</name>
    <message>
        <source>%1 has no known controls: give it some in the gamepad&apos;s dialog.</source>
        <translation>%1 hat keine bekannte Belegung: im Gamepad-Dialog eine festlegen.</translation>
    </message>
</context>
<context>
    <name>leitstand::PadLegend</name>
    <message>
        <source>Controls of the gamepad</source>
        <translation>Belegung des Gamepads</translation>
    </message>
    <message>
        <source>What the gamepad&apos;s controls do; a click closes this</source>
        <translation>Was die Bedienelemente des Gamepads bewirken; ein Klick schließt dies</translation>
    </message>
    <message>
        <source>Gamepad: none is plugged in</source>
        <translation>Gamepad: keines angeschlossen</translation>
    </message>
    <message>
        <source>Gamepad: %1</source>
        <translation>Gamepad: %1</translation>
    </message>
    <message>
        <source>The trigger held and the window in front: the pad drives. STOP works always.</source>
        <translation>Totmanntaste gehalten und Fenster vorn: das Pad fährt. STOP wirkt immer.</translation>
    </message>
</context>
<context>
    <name>leitstand::PadMappingDialog</name>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>The gamepad that drives; STOP works on all</source>
        <translation>Das Gamepad, das fährt; STOP wirkt auf allen</translation>
    </message>
    <message>
        <source>Gamepad that drives</source>
        <translation>Gamepad, das fährt</translation>
    </message>
    <message>
        <source>What the gamepad does, and by which control</source>
        <translation>Was das Gamepad bewirkt und mit welchem Bedienelement</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Dead zone</source>
        <translation>&amp;Totzone</translation>
    </message>
    <message>
        <source>Around the middle of a stick nothing moves</source>
        <translation>Um die Mitte eines Sticks bewegt sich nichts</translation>
    </message>
    <message>
        <source>&amp;Fine middle</source>
        <translation>&amp;Feine Mitte</translation>
    </message>
    <message>
        <source>Sticks are finer around their middle</source>
        <translation>Sticks sind um ihre Mitte feiner</translation>
    </message>
    <message>
        <source>&amp;Trigger at</source>
        <translation>Trigger &amp;ab</translation>
    </message>
    <message>
        <source>How far a trigger is pulled until it counts</source>
        <translation>Wie weit ein Trigger gezogen wird, bis er zählt</translation>
    </message>
    <message>
        <source>Forward ← → back</source>
        <translation>Vorwärts ← → zurück</translation>
    </message>
    <message>
        <source>Turn left ← → right</source>
        <translation>Drehen links ← → rechts</translation>
    </message>
    <message>
        <source>Camera left ← → right</source>
        <translation>Kamera links ← → rechts</translation>
    </message>
    <message>
        <source>Camera up ← → down</source>
        <translation>Kamera hoch ← → runter</translation>
    </message>
    <message>
        <source>Se&amp;t …</source>
        <translation>Set&amp;zen …</translation>
    </message>
    <message>
        <source>The next control that you push does what is selected</source>
        <translation>Das nächste betätigte Bedienelement bewirkt das Gewählte</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>No control does what is selected</source>
        <translation>Kein Bedienelement bewirkt das Gewählte</translation>
    </message>
    <message>
        <source>&amp;Usual</source>
        <translation>Ü&amp;blich</translation>
    </message>
    <message>
        <source>What gamepads usually do here; not saved yet</source>
        <translation>Was Gamepads hier üblicherweise bewirken; noch nicht gespeichert</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Use this now, and whenever such a gamepad is plugged in</source>
        <translation>Dies jetzt verwenden und immer, wenn ein solches Gamepad angeschlossen wird</translation>
    </message>
    <message>
        <source>No gamepad is plugged in</source>
        <translation>Kein Gamepad ist angeschlossen</translation>
    </message>
    <message>
        <source>Canc&amp;el</source>
        <translation>Abbr&amp;echen</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Push the control for “%1” now.</source>
        <translation>Jetzt das Bedienelement für „%1“ betätigen.</translation>
    </message>
</context>
<context>
    <name>leitstand::PadTable</name>
    <message>
        <source>“%1” needs a control.</source>
        <translation>„%1“ braucht ein Bedienelement.</translation>
    </message>
    <message>
        <source>%1 stops all robots, and does nothing else.</source>
        <translation>%1 hält alle Roboter an und tut sonst nichts.</translation>
    </message>
    <message>
        <source>push it now …</source>
        <translation>jetzt betätigen …</translation>
    </message>
    <message>
        <source>does</source>
        <translation>bewirkt</translation>
    </message>
    <message>
        <source>control</source>
        <translation>Element</translation>
    </message>
</context>
<context>
    <name>leitstand::PadTexts</name>
    <message>
        <source>Left stick left</source>
        <translation>Linker Stick links</translation>
    </message>
    <message>
        <source>Left stick right</source>
        <translation>Linker Stick rechts</translation>
    </message>
    <message>
        <source>Left stick up</source>
        <translation>Linker Stick hoch</translation>
    </message>
    <message>
        <source>Left stick down</source>
        <translation>Linker Stick runter</translation>
    </message>
    <message>
        <source>Right stick left</source>
        <translation>Rechter Stick links</translation>
    </message>
    <message>
        <source>Right stick right</source>
        <translation>Rechter Stick rechts</translation>
    </message>
    <message>
        <source>Right stick up</source>
        <translation>Rechter Stick hoch</translation>
    </message>
    <message>
        <source>Right stick down</source>
        <translation>Rechter Stick runter</translation>
    </message>
    <message>
        <source>Left trigger</source>
        <translation>Linker Trigger</translation>
    </message>
    <message>
        <source>Right trigger</source>
        <translation>Rechter Trigger</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Left stick pressed</source>
        <translation>Linker Stick gedrückt</translation>
    </message>
    <message>
        <source>Right stick pressed</source>
        <translation>Rechter Stick gedrückt</translation>
    </message>
    <message>
        <source>Left shoulder</source>
        <translation>Linke Schulter</translation>
    </message>
    <message>
        <source>Right shoulder</source>
        <translation>Rechte Schulter</translation>
    </message>
    <message>
        <source>Cross up</source>
        <translation>Kreuz hoch</translation>
    </message>
    <message>
        <source>Cross down</source>
        <translation>Kreuz runter</translation>
    </message>
    <message>
        <source>Cross left</source>
        <translation>Kreuz links</translation>
    </message>
    <message>
        <source>Cross right</source>
        <translation>Kreuz rechts</translation>
    </message>
    <message>
        <source>Hold to drive</source>
        <translation>Totmanntaste</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>Drehen links</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Drehen rechts</translation>
    </message>
    <message>
        <source>Sideways left</source>
        <translation>Seitwärts links</translation>
    </message>
    <message>
        <source>Sideways right</source>
        <translation>Seitwärts rechts</translation>
    </message>
    <message>
        <source>Turbo</source>
        <translation>Turbo</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>Langsam</translation>
    </message>
    <message>
        <source>STOP all robots</source>
        <translation>STOP alle Roboter</translation>
    </message>
    <message>
        <source>Camera left</source>
        <translation>Kamera links</translation>
    </message>
    <message>
        <source>Camera right</source>
        <translation>Kamera rechts</translation>
    </message>
    <message>
        <source>Camera up</source>
        <translation>Kamera hoch</translation>
    </message>
    <message>
        <source>Camera down</source>
        <translation>Kamera runter</translation>
    </message>
    <message>
        <source>Hold: without eyes</source>
        <translation>Halten: ohne Sicht</translation>
    </message>
    <message>
        <source>The robot moves only while this is held; letting it go stops it at once</source>
        <translation>Der Roboter bewegt sich nur, solange sie gehalten wird; Loslassen hält ihn sofort an</translation>
    </message>
    <message>
        <source>All of the robot&apos;s speed instead of 60 %</source>
        <translation>Volles Tempo des Roboters statt 60 %</translation>
    </message>
    <message>
        <source>A quarter of the robot&apos;s speed</source>
        <translation>Ein Viertel des Tempos des Roboters</translation>
    </message>
    <message>
        <source>While it is held, old or missing pictures do not cap the speed</source>
        <translation>Solange gehalten, begrenzen alte oder fehlende Bilder das Tempo nicht</translation>
    </message>
    <message>
        <source>Stops all robots, always: without the trigger, and whatever window has the focus</source>
        <translation>Hält alle Roboter an, immer: ohne Totmanntaste und gleich welches Fenster den Fokus hat</translation>
    </message>
    <message>
        <source>For robots that can drive sideways</source>
        <translation>Für Roboter, die seitwärts fahren können</translation>
    </message>
    <message>
        <source>Turns the cameras, also while the robot stands</source>
        <translation>Dreht die Kameras, auch wenn der Roboter steht</translation>
    </message>
    <message>
        <source>Drives the selected robot while the trigger is held</source>
        <translation>Fährt den gewählten Roboter, solange die Totmanntaste gehalten wird</translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation>Knopf %1</translation>
    </message>
    <message>
        <source>Axis %1 %2</source>
        <translation>Achse %1 %2</translation>
    </message>
    <message>
        <source>Nothing moves: no control is bound to “%1”.</source>
        <translation>Nichts bewegt sich: „%1“ ist nicht belegt.</translation>
    </message>
    <message>
        <source>Hold “%1” first, then push the stick; let it go and the robot stands.</source>
        <translation>Erst „%1“ halten, dann den Stick bewegen; beim Loslassen steht der Roboter.</translation>
    </message>
    <message>
        <source>Plug one in, or pair it by Bluetooth, at any time: what SDL knows works at once (Xbox, DualShock, DualSense, Switch Pro, Steam; Logitech and 8BitDo in their X mode). Any other joystick is bound in the menu Robot, Gamepad: STOP first. This is what the controls would do:</source>
        <translation>Jederzeit einstecken oder über Bluetooth koppeln: was SDL kennt, geht sofort (Xbox, DualShock, DualSense, Switch Pro, Steam; Logitech und 8BitDo im X-Modus). Andere Joysticks werden im Menü Roboter, Gamepad belegt: STOP zuerst. Das täten die Bedienelemente:</translation>
    </message>
    <message>
        <source>Until then keys drive: F2, then W S A D or the arrows; Shift slow, Ctrl fast; Space halts; G held drives without eyes; Esc stops all robots, always.</source>
        <translation>Bis dahin fahren Tasten: F2, dann W S A D oder die Pfeile; Umschalt langsam, Strg schnell; Leertaste hält an; G gehalten fährt ohne Sicht; Esc hält immer alle Roboter an.</translation>
    </message>
</context>
<context>
    <name>leitstand::PlaceRobot</name>
    <message>
        <source>P&amp;lace a robot</source>
        <translation>Roboter pla&amp;tzieren</translation>
    </message>
    <message>
        <source>Click on the map where a robot stands that is not in it yet, or the selected one; drag its heading</source>
        <translation>Auf der Karte anklicken, wo ein Roboter steht, der noch nicht darin ist, oder der gewählte; Richtung ziehen</translation>
    </message>
    <message>
        <source>Click where %1 stands, drag its heading · right button: not at all</source>
        <translation>Anklicken, wo %1 steht, Richtung ziehen · rechte Taste: abbrechen</translation>
    </message>
    <message>
        <source>F&amp;ind the robot in the whole map</source>
        <translation>Roboter in der ganzen Karte s&amp;uchen</translation>
    </message>
    <message>
        <source>Looks by the newest 3D scan of the selected robot for where it stands, anywhere in the map: for one that was carried or is lost</source>
        <translation>Sucht mit dem neuesten 3D-Scan des gewählten Roboters, wo er steht, überall in der Karte: für einen, der getragen wurde oder verloren ist</translation>
    </message>
</context>
<context>
    <name>leitstand::PreflightFeature</name>
    <message>
        <source>&amp;Preflight...</source>
        <translation>Vor&amp;prüfung...</translation>
    </message>
    <message>
        <source>What is in order before the mission and what is not; brake tests; adding robots</source>
        <translation>Was vor der Mission in Ordnung ist und was nicht; Bremstests; Roboter hinzufügen</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>Vorprüfung</translation>
    </message>
    <message>
        <source>NO WATCHDOG: %1</source>
        <translation>KEIN WATCHDOG: %1</translation>
    </message>
    <message>
        <source>Failed its brake test and is driven nevertheless: without radio it goes on. When this station hangs or dies, its guard stops it</source>
        <translation>Hat die Bremsprüfung nicht bestanden und wird dennoch gefahren: ohne Funk fährt er weiter. Hängt oder endet diese Station, hält ihn sein Wächter an</translation>
    </message>
    <message>
        <source>BRAKES LATE: %1</source>
        <translation>SPÄTE BREMSE: %1</translation>
    </message>
    <message>
        <source>Failed its brake test and is driven nevertheless: without radio it stands late</source>
        <translation>Hat die Bremsprüfung nicht bestanden und wird dennoch gefahren: ohne Funk steht er spät</translation>
    </message>
    <message>
        <source>%1 is not heard any more</source>
        <translation>%1 ist nicht mehr zu hören</translation>
    </message>
    <message>
        <source>Robot file</source>
        <translation>Roboterdatei</translation>
    </message>
    <message>
        <source>Robot files (*.yaml *.yml)</source>
        <translation>Roboterdateien (*.yaml *.yml)</translation>
    </message>
</context>
<context>
    <name>leitstand::PreflightList</name>
    <message>
        <source>Station</source>
        <translation>Station</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>%1 MB/s</source>
        <translation>%1 MB/s</translation>
    </message>
    <message>
        <source>stands after %1 and %2 cm</source>
        <translation>steht nach %1 und %2 cm</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>clock %1 behind ours</source>
        <translation>Uhr geht gegen unsere %1 nach</translation>
    </message>
    <message>
        <source>clock %1 ahead of ours</source>
        <translation>Uhr geht gegen unsere %1 vor</translation>
    </message>
    <message>
        <source>connected, but %1</source>
        <translation>verbunden, aber %1</translation>
    </message>
    <message>
        <source>connected, round trip %1</source>
        <translation>verbunden, Umlaufzeit %1</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>silent for %1</source>
        <translation>still seit %1</translation>
    </message>
    <message>
        <source>not heard yet</source>
        <translation>noch nicht gehört</translation>
    </message>
    <message>
        <source>%1 streams come</source>
        <translation>%1 Datenströme kommen</translation>
    </message>
    <message>
        <source>never came: %1</source>
        <translation>kamen nie: %1</translation>
    </message>
    <message>
        <source>do not come any more: %1</source>
        <translation>kommen nicht mehr: %1</translation>
    </message>
    <message>
        <source>camera pictures are fresh</source>
        <translation>Kamerabilder sind frisch</translation>
    </message>
    <message>
        <source>no fresh pictures: %1</source>
        <translation>keine frischen Bilder: %1</translation>
    </message>
    <message>
        <source>its clock is not known yet</source>
        <translation>seine Uhr ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>this station may drive it</source>
        <translation>diese Station darf ihn fahren</translation>
    </message>
    <message>
        <source>drive control is free</source>
        <translation>Fahrrecht frei</translation>
    </message>
    <message>
        <source>%1 has drive control</source>
        <translation>%1 hat das Fahrrecht</translation>
    </message>
    <message>
        <source>hears no drive commands</source>
        <translation>hört keine Fahrbefehle</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>brake: %1 without commands</source>
        <translation>Bremse: %1 ohne Befehle</translation>
    </message>
    <message>
        <source>brake: tested more than a day ago, %1</source>
        <translation>Bremse: vor mehr als einem Tag getestet, %1</translation>
    </message>
    <message>
        <source>brake: not tested</source>
        <translation>Bremse: nicht getestet</translation>
    </message>
    <message>
        <source>brake: FAILED, %1; driving is refused</source>
        <translation>Bremse: DURCHGEFALLEN, %1; Fahren wird verweigert</translation>
    </message>
    <message>
        <source>brake: FAILED, and driven nevertheless</source>
        <translation>Bremse: DURCHGEFALLEN, wird dennoch gefahren</translation>
    </message>
    <message>
        <source>brake: FAILED, and driven nevertheless; %1</source>
        <translation>Bremse: DURCHGEFALLEN, wird dennoch gefahren; %1</translation>
    </message>
    <message>
        <source>brakes after %1, stands after %2 and %3 cm</source>
        <translation>bremst nach %1, steht nach %2 und %3 cm</translation>
    </message>
    <message>
        <source>still moves %1 after the last command</source>
        <translation>fährt %1 nach dem letzten Befehl noch</translation>
    </message>
    <message>
        <source>moves without commands</source>
        <translation>fährt ohne Befehle</translation>
    </message>
    <message>
        <source>its guard is not heard by it yet</source>
        <translation>sein Wächter wird von ihm noch nicht gehört</translation>
    </message>
    <message>
        <source>its guard stands by</source>
        <translation>sein Wächter steht bereit</translation>
    </message>
    <message>
        <source>no guard: %1</source>
        <translation>kein Wächter: %1</translation>
    </message>
    <message>
        <source>brake: no result (%1)</source>
        <translation>Bremse: kein Ergebnis (%1)</translation>
    </message>
    <message>
        <source>not secured: anybody in the network may speak</source>
        <translation>nicht gesichert: jeder im Netz darf mitreden</translation>
    </message>
    <message>
        <source>robot &quot;%1&quot; is heard, and not driven</source>
        <translation>Roboter &quot;%1&quot; ist zu hören und wird nicht gefahren</translation>
    </message>
    <message>
        <source>network: %1</source>
        <translation>Netz: %1</translation>
    </message>
    <message>
        <source>network: this computer only</source>
        <translation>Netz: nur dieser Rechner</translation>
    </message>
    <message>
        <source>disk: room for %1, writes %2</source>
        <translation>Platte: Platz für %1, schreibt %2</translation>
    </message>
    <message>
        <source>disk: room for %1</source>
        <translation>Platte: Platz für %1</translation>
    </message>
    <message>
        <source>disk: writes only %1, the log needs %2</source>
        <translation>Platte: schreibt nur %1, das Log braucht %2</translation>
    </message>
    <message>
        <source>disk: room for %1 only</source>
        <translation>Platte: Platz nur für %1</translation>
    </message>
    <message>
        <source>nothing is recorded: %1</source>
        <translation>nichts wird aufgezeichnet: %1</translation>
    </message>
    <message>
        <source>gamepad: %1</source>
        <translation>Gamepad: %1</translation>
    </message>
    <message>
        <source>no gamepad: keys drive</source>
        <translation>kein Gamepad: Tasten fahren</translation>
    </message>
    <message>
        <source>Add it below</source>
        <translation>Unten hinzufügen</translation>
    </message>
    <message>
        <source>Is it on, in this network, and in this domain?</source>
        <translation>Ist er an, in diesem Netz und in dieser Domäne?</translation>
    </message>
    <message>
        <source>Come nearer, or thin the link (T)</source>
        <translation>Näher herangehen oder Funk sparen (T)</translation>
    </message>
    <message>
        <source>Is the sensor on? Does the robot&apos;s file name its topic?</source>
        <translation>Ist der Sensor an? Nennt die Roboterdatei sein Topic?</translation>
    </message>
    <message>
        <source>Is the camera on? Its driver may hang</source>
        <translation>Ist die Kamera an? Ihr Treiber hängt vielleicht</translation>
    </message>
    <message>
        <source>Change the QoS in the robot&apos;s file</source>
        <translation>QoS in der Roboterdatei ändern</translation>
    </message>
    <message>
        <source>Wait a moment</source>
        <translation>Einen Moment warten</translation>
    </message>
    <message>
        <source>Ask for it when you want to drive (F2)</source>
        <translation>Danach fragen, wenn gefahren werden soll (F2)</translation>
    </message>
    <message>
        <source>Is its drive node running? Right topic and type?</source>
        <translation>Läuft sein Fahrknoten? Richtiges Topic, richtiger Typ?</translation>
    </message>
    <message>
        <source>Release it: hold its handle beside STOP</source>
        <translation>Freigeben: seinen Griff neben STOP halten</translation>
    </message>
    <message>
        <source>Test it: hold the button below</source>
        <translation>Testen: unten den Knopf halten</translation>
    </message>
    <message>
        <source>Give it a watchdog, test again, or drive it nevertheless</source>
        <translation>Watchdog einrichten, erneut testen oder dennoch fahren</translation>
    </message>
    <message>
        <source>Lost radio means a robot that goes on</source>
        <translation>Bei Funkverlust fährt der Roboter weiter</translation>
    </message>
    <message>
        <source>Plug the cable in, or choose --interface</source>
        <translation>Kabel anschließen oder --interface wählen</translation>
    </message>
    <message>
        <source>Make room, or record elsewhere (--mission)</source>
        <translation>Platz schaffen oder anderswo aufzeichnen (--mission)</translation>
    </message>
    <message>
        <source>in order</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>to know</source>
        <translation>zur Kenntnis</translation>
    </message>
    <message>
        <source>must be mended</source>
        <translation>zu beheben</translation>
    </message>
    <message>
        <source>needs a look</source>
        <translation>zu prüfen</translation>
    </message>
    <message>
        <source>%1 to be mended</source>
        <translation>%1 zu beheben</translation>
    </message>
    <message>
        <source>%1 to be looked at</source>
        <translation>%1 zu prüfen</translation>
    </message>
    <message>
        <source>All in order</source>
        <translation>Alles in Ordnung</translation>
    </message>
    <message>
        <source>Waits for drive control and standing ... keep holding</source>
        <translation>Wartet auf Fahrrecht und Stillstand ... weiter halten</translation>
    </message>
    <message>
        <source>Drives ... keep holding</source>
        <translation>Fährt ... weiter halten</translation>
    </message>
    <message>
        <source>Says nothing more, and measures ...</source>
        <translation>Sendet nichts mehr und misst ...</translation>
    </message>
    <message>
        <source>0.6 m must be free ahead</source>
        <translation>0.6 m müssen vorn frei sein</translation>
    </message>
    <message>
        <source>Passed: %1</source>
        <translation>Bestanden: %1</translation>
    </message>
    <message>
        <source>FAILED: %1</source>
        <translation>DURCHGEFALLEN: %1</translation>
    </message>
    <message>
        <source>No result: %1</source>
        <translation>Kein Ergebnis: %1</translation>
    </message>
    <message>
        <source>It may drop every drive command as too old: set its clock (NTP)</source>
        <translation>Er verwirft womöglich jeden Fahrbefehl als zu alt: seine Uhr stellen (NTP)</translation>
    </message>
    <message>
        <source>the key was let go</source>
        <translation>die Taste wurde losgelassen</translation>
    </message>
    <message>
        <source>the robot was not to be driven any more</source>
        <translation>der Roboter durfte nicht mehr gefahren werden</translation>
    </message>
    <message>
        <source>nothing tells whether there is room ahead</source>
        <translation>nichts sagt, ob vorn Platz ist</translation>
    </message>
    <message>
        <source>only %1 m are free ahead, %2 m are needed</source>
        <translation>vorn sind nur %1 m frei, nötig sind %2 m</translation>
    </message>
    <message>
        <source>the station may not drive the robot</source>
        <translation>die Station darf den Roboter nicht fahren</translation>
    </message>
    <message>
        <source>the robot hears no drive commands</source>
        <translation>der Roboter hört keine Fahrbefehle</translation>
    </message>
    <message>
        <source>no odometry comes</source>
        <translation>es kommt keine Odometrie</translation>
    </message>
    <message>
        <source>the sticks were not let go</source>
        <translation>die Steuerung wurde nicht losgelassen</translation>
    </message>
    <message>
        <source>the robot did not stand</source>
        <translation>der Roboter stand nicht still</translation>
    </message>
    <message>
        <source>the robot did not come to its speed</source>
        <translation>der Roboter kam nicht auf seine Geschwindigkeit</translation>
    </message>
    <message>
        <source>no odometry came after the cut</source>
        <translation>nach dem Abbruch der Befehle kam keine Odometrie</translation>
    </message>
    <message>
        <source>nothing tells why</source>
        <translation>der Grund ist nicht bekannt</translation>
    </message>
    <message>
        <source>Plug in a loudspeaker, then try the tones</source>
        <translation>Lautsprecher anschließen, dann die Töne ausprobieren</translation>
    </message>
    <message>
        <source>sound: there is a device; try the tones</source>
        <translation>Ton: ein Gerät ist da; bitte Töne probieren</translation>
    </message>
    <message>
        <source>network set by ROS&apos;s environment: %1</source>
        <translation>Netz nach der Umgebung von ROS: %1</translation>
    </message>
    <message>
        <source>STOP is a zero command: it has no stop of its own, and obeys others, too</source>
        <translation>STOP ist ein Nullbefehl: er hat keinen eigenen Halt und gehorcht auch anderen</translation>
    </message>
    <message>
        <source>STOP also locks %1</source>
        <translation>STOP sperrt auch %1</translation>
    </message>
    <message>
        <source>nobody listens to %1: STOP does not hold off what others send</source>
        <translation>niemand hört auf %1: STOP hält nicht ab, was andere senden</translation>
    </message>
    <message>
        <source>STOP also calls %1</source>
        <translation>STOP ruft auch %1 auf</translation>
    </message>
    <message>
        <source>nobody offers %1: STOP cannot call it</source>
        <translation>niemand bietet %1 an: STOP kann es nicht aufrufen</translation>
    </message>
    <message>
        <source>nobody tells where %1 sits: it counts as sitting at the robot&apos;s base</source>
        <translation>niemand sagt, wo %1 sitzt: es zählt als am Fußpunkt des Roboters</translation>
    </message>
    <message>
        <source>Publish its transform (tf_static), or enter its place in the robot&apos;s file</source>
        <translation>Die Transformation veröffentlichen (tf_static) oder den Ort in die Roboterdatei eintragen</translation>
    </message>
</context>
<context>
    <name>leitstand::PreflightPage</name>
    <message>
        <source>Checks before the mission</source>
        <translation>Prüfungen vor der Mission</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Neu prüfen</translation>
    </message>
    <message>
        <source>Measures the disk again; everything else is checked once a second</source>
        <translation>Misst die Platte neu; alles andere wird jede Sekunde geprüft</translation>
    </message>
    <message>
        <source>Robot whose brake is tested</source>
        <translation>Roboter, dessen Bremse getestet wird</translation>
    </message>
    <message>
        <source>Hold to test the brake</source>
        <translation>Halten: Bremse testen</translation>
    </message>
    <message>
        <source>Drives 0.1 m/s ahead for a second at most, then sends nothing and measures when the robot stands. Letting go ends it; Esc stops all.</source>
        <translation>Fährt höchstens eine Sekunde mit 0.1 m/s voraus, sendet dann nichts mehr und misst, wann der Roboter steht. Loslassen beendet es; Esc hält alle an.</translation>
    </message>
    <message>
        <source>Drive it nevertheless</source>
        <translation>Dennoch fahren</translation>
    </message>
    <message>
        <source>This robot goes on when the radio is lost. Until the program ends.</source>
        <translation>Dieser Roboter fährt weiter, wenn der Funk verloren geht. Gilt bis zum Programmende.</translation>
    </message>
    <message>
        <source>Brake test</source>
        <translation>Bremstest</translation>
    </message>
    <message>
        <source>Robots that are heard and not driven</source>
        <translation>Roboter, die zu hören sind und nicht gefahren werden</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Writes a first file of the robot and takes it into the station</source>
        <translation>Schreibt eine erste Datei des Roboters und nimmt ihn in die Station auf</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>Aus Datei...</translation>
    </message>
    <message>
        <source>A robot file (YAML)</source>
        <translation>Eine Roboterdatei (YAML)</translation>
    </message>
    <message>
        <source>Another robot</source>
        <translation>Weiterer Roboter</translation>
    </message>
    <message>
        <source>Try the tones</source>
        <translation>Töne ausprobieren</translation>
    </message>
    <message>
        <source>Plays the tones of alarms: to look, then to act</source>
        <translation>Spielt die Töne der Alarme: zum Ansehen, dann zum Handeln</translation>
    </message>
</context>
<context>
    <name>leitstand::ReadingRowsModel</name>
    <message>
        <source>Reading</source>
        <translation>Messwert</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Amber outside %1</source>
        <translation>Gelb außerhalb von %1</translation>
    </message>
    <message>
        <source>Red outside %1</source>
        <translation>Rot außerhalb von %1</translation>
    </message>
</context>
<context>
    <name>leitstand::ReadingWords</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>leitstand::Readings</name>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>humidity</source>
        <translation>Luftfeuchte</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>Luftdruck</translation>
    </message>
    <message>
        <source>magnetic field</source>
        <translation>Magnetfeld</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>latitude</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>longitude</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>altitude</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>leitstand::ReadingsFeature</name>
    <message>
        <source>&amp;Readings of its sensors</source>
        <translation>&amp;Messwerte seiner Sensoren</translation>
    </message>
    <message>
        <source>Temperatures, distances and all other numbers that the robot&apos;s file names, with their limits</source>
        <translation>Temperaturen, Abstände und alle anderen Zahlen, die die Datei des Roboters nennt, mit ihren Grenzen</translation>
    </message>
</context>
<context>
    <name>leitstand::ReadingsPanel</name>
    <message>
        <source>Readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Readings of the robot&apos;s sensors</source>
        <translation>Messwerte der Sensoren des Roboters</translation>
    </message>
    <message>
        <source>This robot&apos;s file names no readings</source>
        <translation>Die Datei dieses Roboters nennt keine Messwerte</translation>
    </message>
</context>
<context>
    <name>leitstand::RecordLight</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>leitstand::RecordText</name>
    <message>
        <source>Recorded into %1</source>
        <translation>Aufgezeichnet in %1</translation>
    </message>
    <message>
        <source>%1 MB in this session</source>
        <translation>%1 MB in dieser Sitzung</translation>
    </message>
    <message>
        <source>rec</source>
        <translation>rec</translation>
    </message>
    <message>
        <source>the disk lasts %1 min</source>
        <translation>die Platte reicht %1 min</translation>
    </message>
    <message>
        <source>rec · disk %1 min</source>
        <translation>rec · Platte %1 min</translation>
    </message>
    <message>
        <source>rec · %1 lost</source>
        <translation>rec · %1 verloren</translation>
    </message>
    <message>
        <source>%1 events could not be written</source>
        <translation>%1 Ereignisse konnten nicht geschrieben werden</translation>
    </message>
    <message>
        <source>not recording</source>
        <translation>keine Aufnahme</translation>
    </message>
</context>
<context>
    <name>leitstand::RegistrationCommands</name>
    <message>
        <source>Register &amp;again</source>
        <translation>&amp;Neu registrieren</translation>
    </message>
    <message>
        <source>Registers all scans again with the present settings</source>
        <translation>Registriert alle Scans neu mit den jetzigen Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Ends reading and registering</source>
        <translation>Beendet Lesen und Registrieren</translation>
    </message>
</context>
<context>
    <name>leitstand::RegistrationPanel</name>
    <message>
        <source>M&amp;inimise</source>
        <translation>M&amp;inimierung</translation>
    </message>
    <message>
        <source>&amp;Nearest points</source>
        <translation>Nächste Pu&amp;nkte</translation>
    </message>
    <message>
        <source>A&amp;pproximation ε</source>
        <translation>Näh&amp;erung ε</translation>
    </message>
    <message>
        <source>The point found is at most (1 + ε) times as far as the nearest one (Arya &amp; Mount 1993); 0: exact. Applies to the approximate tree and the forest.</source>
        <translation>Der gefundene Punkt ist höchstens (1 + ε)-mal so weit entfernt wie der nächste (Arya &amp; Mount 1993); 0: exakt. Gilt für den genäherten Baum und den Wald.</translation>
    </message>
    <message>
        <source>Pairs of points farther apart are dropped. Several values are stages, one after another: &quot;1.5, 0.5&quot; comes home from starts that are up to 1 m and 20° wrong.</source>
        <translation>Weiter entfernte Punktpaare werden verworfen. Mehrere Werte sind Stufen nacheinander: &quot;1.5, 0.5&quot; findet aus Startposen zurück, die bis zu 1 m und 20° falsch sind.</translation>
    </message>
    <message>
        <source>0.01 to 10 m, each at most the one before: 1.5, 0.5</source>
        <translation>0.01 bis 10 m, jeder höchstens so groß wie der vorige: 1.5, 0.5</translation>
    </message>
    <message>
        <source>Steps at m&amp;ost</source>
        <translation>Schritte &amp;höchstens</translation>
    </message>
    <message>
        <source>Iterations of the ICP for a scan, over all stages.</source>
        <translation>Iterationen des ICP für einen Scan, über alle Stufen.</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>all points</source>
        <translation>alle Punkte</translation>
    </message>
    <message>
        <source>Voxe&amp;ls</source>
        <translation>Voxe&amp;l</translation>
    </message>
    <message>
        <source>Fil&amp;ter</source>
        <translation>Fil&amp;ter</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Ran&amp;ge</source>
        <translation>&amp;Reichweite</translation>
    </message>
    <message>
        <source>Points nearer than the first (the robot itself) and farther than the second (no echo) take no part.</source>
        <translation>Punkte, die näher als der erste Wert (der Roboter selbst) oder weiter als der zweite (kein Echo) sind, nehmen nicht teil.</translation>
    </message>
    <message>
        <source>&amp;Start from</source>
        <translation>Start &amp;bei</translation>
    </message>
    <message>
        <source>Match &amp;against</source>
        <translation>Ab&amp;gleich mit</translation>
    </message>
    <message>
        <source>all cores</source>
        <translation>alle Kerne</translation>
    </message>
    <message>
        <source>Thr&amp;eads</source>
        <translation>Threa&amp;ds</translation>
    </message>
    <message>
        <source>How many processor cores may work at once.</source>
        <translation>Wie viele Prozessorkerne gleichzeitig arbeiten dürfen.</translation>
    </message>
    <message>
        <source>Defa&amp;ults</source>
        <translation>&amp;Vorgaben</translation>
    </message>
    <message>
        <source>Puts every setting back to where it was at first.</source>
        <translation>Setzt jede Einstellung auf den Anfangswert zurück.</translation>
    </message>
    <message>
        <source>Maximum &amp;distance</source>
        <translation>Max. Ab&amp;stand</translation>
    </message>
    <message>
        <source>Edge of the voxel grid: one point is kept in each voxel. 0 uses all points. A grid of 10 cm moves the result by some centimetres and takes a fraction of the time.</source>
        <translation>Kantenlänge des Voxelgitters: je Voxel bleibt ein Punkt. 0 verwendet alle Punkte. Ein Gitter von 10 cm verschiebt das Ergebnis um einige Zentimeter und braucht einen Bruchteil der Zeit.</translation>
    </message>
</context>
<context>
    <name>leitstand::RegistrationSettings</name>
    <message>
        <source>Brute force</source>
        <translation>Brute Force</translation>
    </message>
    <message>
        <source>Compares every point with every point: exact and very slow (first row of the paper&apos;s Table 1). Reduce the points first.</source>
        <translation>Vergleicht jeden Punkt mit jedem: exakt und sehr langsam (erste Zeile von Tabelle 1 der Veröffentlichung). Zuerst die Punkte reduzieren.</translation>
    </message>
    <message>
        <source>k-d tree</source>
        <translation>k-d-Baum</translation>
    </message>
    <message>
        <source>Exact search in an optimised k-d tree (Friedman, Bentley &amp; Finkel 1977).</source>
        <translation>Exakte Suche in einem optimierten k-d-Baum (Friedman, Bentley &amp; Finkel 1977).</translation>
    </message>
    <message>
        <source>Approximate k-d tree</source>
        <translation>Genäherter k-d-Baum</translation>
    </message>
    <message>
        <source>A k-d tree that may answer a point up to (1 + ε) times as far as the nearest (Arya &amp; Mount 1993).</source>
        <translation>Ein k-d-Baum, der einen Punkt liefern darf, der bis zu (1 + ε)-mal so weit entfernt ist wie der nächste (Arya &amp; Mount 1993).</translation>
    </message>
    <message>
        <source>Forest, a tree per label</source>
        <translation>Wald, ein Baum je Label</translation>
    </message>
    <message>
        <source>Floor, wall and ceiling points look for their own kind only, each in an approximate tree of its own (the paper, section 2.2).</source>
        <translation>Boden-, Wand- und Deckenpunkte suchen nur ihresgleichen, jede Art in einem eigenen genäherten Baum (die Veröffentlichung, Abschnitt 2.2).</translation>
    </message>
    <message>
        <source>Points · SVD</source>
        <translation>Punkte · SVD</translation>
    </message>
    <message>
        <source>Point to point, closed form by singular value decomposition (Arun, Huang &amp; Blostein 1987).</source>
        <translation>Punkt zu Punkt, geschlossene Lösung durch Singulärwertzerlegung (Arun, Huang &amp; Blostein 1987).</translation>
    </message>
    <message>
        <source>Points · unit quaternion</source>
        <translation>Punkte · Einheitsquaternion</translation>
    </message>
    <message>
        <source>Point to point, closed form by unit quaternions (Horn 1987).</source>
        <translation>Punkt zu Punkt, geschlossene Lösung durch Einheitsquaternionen (Horn 1987).</translation>
    </message>
    <message>
        <source>Points · orthonormal matrix</source>
        <translation>Punkte · Orthonormalmatrix</translation>
    </message>
    <message>
        <source>Point to point, closed form by orthonormal matrices (Horn, Hilden &amp; Negahdaripour 1988).</source>
        <translation>Punkt zu Punkt, geschlossene Lösung durch orthonormale Matrizen (Horn, Hilden &amp; Negahdaripour 1988).</translation>
    </message>
    <message>
        <source>Points · dual quaternion</source>
        <translation>Punkte · duale Quaternion</translation>
    </message>
    <message>
        <source>Point to point, closed form by dual quaternions (Walker, Shao &amp; Volz 1991).</source>
        <translation>Punkt zu Punkt, geschlossene Lösung durch duale Quaternionen (Walker, Shao &amp; Volz 1991).</translation>
    </message>
    <message>
        <source>Point to plane</source>
        <translation>Punkt zu Ebene</translation>
    </message>
    <message>
        <source>Distances to the planes of the reference: fewer steps on walls and floors (Chen &amp; Medioni 1991).</source>
        <translation>Abstände zu den Ebenen der Referenz: weniger Schritte an Wänden und Böden (Chen &amp; Medioni 1991).</translation>
    </message>
    <message>
        <source>Plane to plane (GICP)</source>
        <translation>Ebene zu Ebene (GICP)</translation>
    </message>
    <message>
        <source>Distances between small planes of both scans: fewest steps, hardly depends on the maximum distance (Segal, Haehnel &amp; Thrun 2009).</source>
        <translation>Abstände zwischen kleinen Ebenen beider Scans: wenigste Schritte, hängt kaum vom maximalen Abstand ab (Segal, Haehnel &amp; Thrun 2009).</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>All points go on to the voxels.</source>
        <translation>Alle Punkte gehen weiter zu den Voxeln.</translation>
    </message>
    <message>
        <source>Median and reduction</source>
        <translation>Median und Reduktion</translation>
    </message>
    <message>
        <source>The paper&apos;s filter for organised scans: outliers of a raw scan become the median of their neighbours, close points are joined.</source>
        <translation>Der Filter der Veröffentlichung für geordnete Scans: Ausreißer eines Rohscans werden zum Median ihrer Nachbarn, nahe Punkte werden zusammengefasst.</translation>
    </message>
    <message>
        <source>Odometry</source>
        <translation>Odometrie</translation>
    </message>
    <message>
        <source>Each scan starts where the robot&apos;s odometry puts it after the scan before.</source>
        <translation>Jeder Scan beginnt dort, wohin die Odometrie des Roboters ihn nach dem vorigen Scan setzt.</translation>
    </message>
    <message>
        <source>Pose of the scan before</source>
        <translation>Pose des vorigen Scans</translation>
    </message>
    <message>
        <source>Each scan starts at the registered pose of the scan before: for scans without odometry.</source>
        <translation>Jeder Scan beginnt an der registrierten Pose des vorigen: für Scans ohne Odometrie.</translation>
    </message>
    <message>
        <source>Previous scan</source>
        <translation>Voriger Scan</translation>
    </message>
    <message>
        <source>Each scan is matched against the one before it.</source>
        <translation>Jeder Scan wird mit dem vorigen abgeglichen.</translation>
    </message>
    <message>
        <source>Whole map</source>
        <translation>Ganze Karte</translation>
    </message>
    <message>
        <source>Each scan is matched against all scans so far (metascan): slower, drifts less.</source>
        <translation>Jeder Scan wird mit allen bisherigen abgeglichen (Metascan): langsamer, driftet weniger.</translation>
    </message>
</context>
<context>
    <name>leitstand::ReleaseHandle</name>
    <message>
        <source>Release %1</source>
        <translation>%1 freigeben</translation>
    </message>
    <message>
        <source>%1 · hold to release</source>
        <translation>%1 · halten: freigeben</translation>
    </message>
    <message>
        <source>Hold this button for one second to let %1 move again.</source>
        <translation>Diesen Knopf eine Sekunde gedrückt halten, damit %1 wieder fahren darf.</translation>
    </message>
</context>
<context>
    <name>leitstand::ReportFeature</name>
    <message>
        <source>Mission d&amp;ata…</source>
        <translation>Missions&amp;daten…</translation>
    </message>
    <message>
        <source>Competition, team, operators, rules of the score: what the report says</source>
        <translation>Wettbewerb, Team, Fahrer, Regeln der Wertung: was im Bericht steht</translation>
    </message>
    <message>
        <source>&amp;Report into a folder…</source>
        <translation>&amp;Bericht in einen Ordner…</translation>
    </message>
    <message>
        <source>Writes the judges&apos; folder now, and again every minute</source>
        <translation>Schreibt den Ordner für die Schiedsrichter jetzt und dann jede Minute</translation>
    </message>
    <message>
        <source>The report is not written any more</source>
        <translation>Der Bericht wird nicht mehr geschrieben</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>Ordner für den Bericht</translation>
    </message>
    <message>
        <source>The report goes on into %1</source>
        <translation>Der Bericht geht weiter nach %1</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
</context>
<context>
    <name>leitstand::ReportText</name>
    <message>
        <source>{}: its {} is missing: {}</source>
        <translation>{}: {} fehlt: {}</translation>
    </message>
    <message>
        <source>{}: its {} cannot be shown: {}</source>
        <translation>{}: {} kann nicht gezeigt werden: {}</translation>
    </message>
    <message>
        <source>the mission holds no events</source>
        <translation>der Einsatz enthält keine Ereignisse</translation>
    </message>
    <message>
        <source>{} samples of {} make no sense, the last one: {}</source>
        <translation>{} Nachrichten von {} ergeben keinen Sinn, die letzte: {}</translation>
    </message>
    <message>
        <source>there is no map: all scans of the mission were set aside or taken back</source>
        <translation>es gibt keine Karte: alle Scans des Einsatzes wurden beiseitegelegt oder zurückgenommen</translation>
    </message>
    <message>
        <source>{} scans are not in the map, since they do not fit and nobody decided on them</source>
        <translation>{} Scans sind nicht in der Karte, da sie nicht passen und niemand über sie entschied</translation>
    </message>
    <message>
        <source>there is no map: {}</source>
        <translation>es gibt keine Karte: {}</translation>
    </message>
    <message>
        <source>no station made a map of this mission: {} of its {} scans were registered for this report, without anyone&apos;s check</source>
        <translation>keine Station hat eine Karte dieses Einsatzes gemacht: {} seiner {} Scans wurden für diesen Bericht registriert, ohne dass jemand sie geprüft hat</translation>
    </message>
    <message>
        <source>cameras looked from more places than are counted: {} views are missing in what was searched</source>
        <translation>Kameras sahen von mehr Orten, als gezählt werden: {} Blicke fehlen im Abgesuchten</translation>
    </message>
    <message>
        <source>the score&apos;s profile &quot;{}&quot; is not there: &quot;{}&quot; is used</source>
        <translation>das Wertungsprofil „{}“ ist nicht da: „{}“ wird benutzt</translation>
    </message>
    <message>
        <source>there is no map: no scan of the mission counts</source>
        <translation>es gibt keine Karte: kein Scan des Einsatzes zählt</translation>
    </message>
    <message>
        <source>without a map there are no GeoTIFF, OctoMap, PLY and pages of the map</source>
        <translation>ohne Karte gibt es weder GeoTIFF noch OctoMap, PLY und Kartenseiten</translation>
    </message>
    <message>
        <source>not confirmed, so in the map but not in the lists: {}</source>
        <translation>nicht bestätigt, also in der Karte, aber nicht in den Listen: {}</translation>
    </message>
    <message>
        <source>competition or team are not given: the files are named for what is missing</source>
        <translation>Wettbewerb oder Team sind nicht angegeben: die Dateien heißen nach dem, was fehlt</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>infrared picture</source>
        <translation>Infrarotbild</translation>
    </message>
    <message>
        <source>CO₂ value</source>
        <translation>CO₂-Wert</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>robot&apos;s pose</source>
        <translation>Pose des Roboters</translation>
    </message>
    <message>
        <source>{} of an earlier report cannot be removed: {}</source>
        <translation>{} eines früheren Berichts lässt sich nicht entfernen: {}</translation>
    </message>
    <message>
        <source>Report written into {}</source>
        <translation>Bericht geschrieben in {}</translation>
    </message>
    <message>
        <source>The report in {} is not whole: {}</source>
        <translation>Der Bericht in {} ist unvollständig: {}</translation>
    </message>
    <message>
        <source>{} of {} scans are of parts of the map that have not met the rest: they lie aside in it, since nobody knows where they belong</source>
        <translation>{} von {} Scans gehören zu Teilen der Karte, die den Rest nicht getroffen haben: sie liegen daneben, denn niemand weiß, wohin sie gehören</translation>
    </message>
</context>
<context>
    <name>leitstand::ReviewComparison</name>
    <message>
        <source>Registering again was cancelled</source>
        <translation>Die erneute Registrierung wurde abgebrochen</translation>
    </message>
</context>
<context>
    <name>leitstand::ReviewReport</name>
    <message>
        <source>The report is being written into %1</source>
        <translation>Der Bericht wird nach %1 geschrieben</translation>
    </message>
</context>
<context>
    <name>leitstand::ReviewWindow</name>
    <message>
        <source>%1 – review – Leitstand</source>
        <translation>%1 – Auswertung – Leitstand</translation>
    </message>
    <message>
        <source>&amp;Register again…</source>
        <translation>Ne&amp;u registrieren…</translation>
    </message>
    <message>
        <source>Registers the mission&apos;s scans again, in a window of its own, with settings of your own; the mission stays as it is</source>
        <translation>Registriert die Scans der Mission neu, in einem eigenen Fenster, mit eigenen Einstellungen; die Mission bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>REVIEW · %1</source>
        <translation>AUSWERTUNG · %1</translation>
    </message>
    <message>
        <source>the mission is still read through</source>
        <translation>die Mission wird noch durchgelesen</translation>
    </message>
    <message>
        <source>The map is being tidied. The review opens again then.</source>
        <translation>Die Karte wird aufgeräumt. Danach öffnet sich die Auswertung neu.</translation>
    </message>
    <message>
        <source>The tidying is taken back. The review opens again then.</source>
        <translation>Das Aufräumen wird zurückgenommen. Danach öffnet sich die Auswertung neu.</translation>
    </message>
    <message>
        <source>Being cancelled…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
    <message>
        <source>How the maps of %1 and %2 lie to each other is not sure: they lie side by side. A station that goes on with this mission joins them by hand</source>
        <translation>Wie die Karten von %1 und %2 zueinander liegen, ist nicht sicher: sie liegen nebeneinander. Eine Station, die mit dieser Mission weitergeht, verbindet sie von Hand</translation>
    </message>
    <message>
        <source>The maps of %1 and %2 are one: of %3 places that were looked for, %4 agree</source>
        <translation>Die Karten von %1 und %2 sind eine: von %3 gesuchten Orten stimmen %4 überein</translation>
    </message>
    <message>
        <source>The maps of %1 and %2 are being merged. The new mission opens then.</source>
        <translation>Die Karten von %1 und %2 werden verbunden. Danach öffnet sich die neue Mission.</translation>
    </message>
    <message>
        <source>&amp;Merge with the map of…</source>
        <translation>&amp;Mit der Karte verbinden von …</translation>
    </message>
    <message>
        <source>Brings the maps of this mission and another one into a new mission, where they have seen the same places; both stay as they are</source>
        <translation>Bringt die Karten dieser und einer anderen Mission in einer neuen zusammen, wo sie dieselben Orte gesehen haben; beide bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Merge with the map of…</source>
        <translation>Mit der Karte verbinden von …</translation>
    </message>
    <message>
        <source>That is this mission: its map is merged with that of another one</source>
        <translation>Das ist diese Mission: ihre Karte wird mit der einer anderen verbunden</translation>
    </message>
    <message>
        <source>A report is being written, or scans are being registered again: merge after that</source>
        <translation>Ein Bericht wird geschrieben, oder Scans werden neu registriert: verbinden Sie danach</translation>
    </message>
    <message>
        <source>; key scans in parts that were mapped apart and are not in it: %1</source>
        <translation>; Schlüsselscans in getrennt kartierten Teilen, die nicht darin sind: %1</translation>
    </message>
    <message>
        <source>Correct the map by &amp;hand…</source>
        <translation>Karte von &amp;Hand berichtigen …</translation>
    </message>
    <message>
        <source>Moves parts of the map, answers where it meets itself, accepts, rejects and registers scans again, in a window of its own; the review is opened again then. What was recorded stays as it is, and each decision can be taken back</source>
        <translation>Verschiebt Teile der Karte, beantwortet, wo sie sich trifft, nimmt Scans an, verwirft sie und registriert sie neu, in einem eigenen Fenster; danach wird die Auswertung neu geöffnet. Was aufgezeichnet wurde, bleibt, wie es ist, und jede Entscheidung lässt sich zurücknehmen</translation>
    </message>
    <message>
        <source>A report is being written, or scans are being registered again: correct the map after that</source>
        <translation>Ein Bericht wird geschrieben, oder Scans werden neu registriert: Berichtigen Sie die Karte danach</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotBar</name>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotBodies</name>
    <message>
        <source>{}: {} meshes of its model are not on this computer, simple shapes are drawn instead ({}). Name the folder with its packages in the robot&apos;s file: packages</source>
        <translation>{}: {} Netze seines Modells sind nicht auf diesem Rechner, einfache Formen werden gezeichnet ({}). Nennen Sie den Ordner mit seinen Paketen in der Datei des Roboters: packages</translation>
    </message>
    <message>
        <source>{}: its model is not drawn: {}</source>
        <translation>{}: Sein Modell wird nicht gezeichnet: {}</translation>
    </message>
    <message>
        <source>it reaches farther than {} m from its base</source>
        <translation>Es reicht weiter als {} m von seiner Basis</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotChip</name>
    <message>
        <source>%1 (%2): %3 · link %4</source>
        <translation>%1 (%2): %3 · Funk %4</translation>
    </message>
    <message>
        <source>battery %1</source>
        <translation>Akku %1</translation>
    </message>
    <message>
        <source>battery %1, %2</source>
        <translation>Akku %1, %2</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>waits</source>
        <comment>for the robot</comment>
        <translation>wartet</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotChipButton</name>
    <message>
        <source>%1 selects</source>
        <translation>%1 wählt ihn</translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation>Roboter %1</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotMark</name>
    <message>
        <source>place certain to %1</source>
        <translation>Ort zu %1 sicher</translation>
    </message>
    <message>
        <source>place uncertain, %1</source>
        <translation>Ort ungewiss, %1</translation>
    </message>
    <message>
        <source>place uncertain</source>
        <translation>Ort ungewiss</translation>
    </message>
    <message>
        <source>link lost: seen here last</source>
        <translation>Funk weg: zuletzt hier gesehen</translation>
    </message>
    <message>
        <source>%1 is not in the map yet</source>
        <translation>%1 ist noch nicht in der Karte</translation>
    </message>
    <message>
        <source>%1 is not in the map yet · %2 places it</source>
        <translation>%1 ist noch nicht in der Karte · %2 setzt ihn hinein</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotRow</name>
    <message>
        <source>%1 · STOP: %2</source>
        <comment>a robot, all of its state, its stop</comment>
        <translation>%1 · STOP: %2</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotSays</name>
    <message>
        <source>started</source>
        <translation>gestartet</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>angefordert</translation>
    </message>
    <message>
        <source>{} cannot be asked for</source>
        <translation>{} lässt sich nicht anfordern</translation>
    </message>
    <message>
        <source>expected a mode, found &quot;{}&quot;</source>
        <translation>Modus erwartet, „{}“ erhalten</translation>
    </message>
    <message>
        <source>the stop stands: release it first</source>
        <translation>der STOP steht: erst freigeben</translation>
    </message>
    <message>
        <source>the radio remote is in use</source>
        <translation>die Fernbedienung ist in Gebrauch</translation>
    </message>
    <message>
        <source>the radio remote was let go of</source>
        <translation>die Fernbedienung wurde losgelassen</translation>
    </message>
    <message>
        <source>no body heat in sight</source>
        <translation>keine Körperwärme in Sicht</translation>
    </message>
    <message>
        <source>body heat in sight</source>
        <translation>Körperwärme in Sicht</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>stopped by {}</source>
        <translation>angehalten von {}</translation>
    </message>
    <message>
        <source>its own button</source>
        <translation>sein eigener Knopf</translation>
    </message>
    <message>
        <source>released</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>the link is back</source>
        <translation>Funk ist wieder da</translation>
    </message>
    <message>
        <source>the link is back: goes on</source>
        <translation>Funk ist wieder da: macht weiter</translation>
    </message>
    <message>
        <source>the link is back: waits to be asked again</source>
        <translation>Funk ist wieder da: wartet auf neuen Auftrag</translation>
    </message>
    <message>
        <source>link lost: stands</source>
        <translation>Funk verloren: steht</translation>
    </message>
    <message>
        <source>link lost: finishes what it does, then waits</source>
        <translation>Funk verloren: beendet, was es tut, wartet dann</translation>
    </message>
    <message>
        <source>link lost: returns to where it was good</source>
        <translation>Funk verloren: fährt zurück, wo er gut war</translation>
    </message>
    <message>
        <source>link lost: finished, waits</source>
        <translation>Funk verloren: fertig, wartet</translation>
    </message>
    <message>
        <source>link lost: waits</source>
        <translation>Funk verloren: wartet</translation>
    </message>
    <message>
        <source>link lost: is back where it was good, waits</source>
        <translation>Funk verloren: ist zurück, wo er gut war, wartet</translation>
    </message>
    <message>
        <source>link lost: finds no way back, waits</source>
        <translation>Funk verloren: findet nicht zurück, wartet</translation>
    </message>
    <message>
        <source>back where the link was good</source>
        <translation>zurück, wo der Funk gut war</translation>
    </message>
    <message>
        <source>the scanner is silent: stands</source>
        <translation>der Scanner schweigt: steht</translation>
    </message>
    <message>
        <source>looks around first</source>
        <translation>sieht sich erst um</translation>
    </message>
    <message>
        <source>at the goal</source>
        <translation>am Ziel</translation>
    </message>
    <message>
        <source>finds no way: looks again</source>
        <translation>findet keinen Weg: sieht noch einmal hin</translation>
    </message>
    <message>
        <source>finds no way to the goal</source>
        <translation>findet keinen Weg zum Ziel</translation>
    </message>
    <message>
        <source>nothing is left to explore</source>
        <translation>nichts mehr zu erkunden</translation>
    </message>
    <message>
        <source>stuck: makes room</source>
        <translation>festgefahren: schafft Platz</translation>
    </message>
    <message>
        <source>looks for a way</source>
        <translation>sucht einen Weg</translation>
    </message>
    <message>
        <source>ran against something: backs out</source>
        <translation>angestoßen: setzt zurück</translation>
    </message>
    <message>
        <source>leans too much: backs out</source>
        <translation>zu schräg: setzt zurück</translation>
    </message>
    <message>
        <source>finds no way off what it ran into</source>
        <translation>kommt von dem Hindernis nicht weg</translation>
    </message>
    <message>
        <source>rolled over: stands</source>
        <translation>umgekippt: steht</translation>
    </message>
    <message>
        <source>no rule applies: stands</source>
        <translation>keine Regel greift: steht</translation>
    </message>
    <message>
        <source>no heat to drive to</source>
        <translation>keine Wärme, zu der es fahren könnte</translation>
    </message>
    <message>
        <source>the heat was lost</source>
        <translation>die Wärme ging verloren</translation>
    </message>
    <message>
        <source>the heat cannot be reached</source>
        <translation>die Wärme ist nicht erreichbar</translation>
    </message>
    <message>
        <source>that victim is known</source>
        <translation>dieses Opfer ist bekannt</translation>
    </message>
    <message>
        <source>gave the approach up</source>
        <translation>Anfahrt aufgegeben</translation>
    </message>
    <message>
        <source>turns to the heat</source>
        <translation>dreht sich zur Wärme</translation>
    </message>
    <message>
        <source>drives towards the heat</source>
        <translation>fährt zur Wärme</translation>
    </message>
    <message>
        <source>drives around what stands before the heat</source>
        <translation>umfährt, was vor der Wärme steht</translation>
    </message>
    <message>
        <source>measures again</source>
        <translation>misst noch einmal</translation>
    </message>
    <message>
        <source>heat {} m ahead</source>
        <translation>Wärme {} m voraus</translation>
    </message>
    <message>
        <source>stands in front of a victim</source>
        <translation>steht vor einem Opfer</translation>
    </message>
    <message>
        <source>stands {} m in front of a victim</source>
        <translation>steht {} m vor einem Opfer</translation>
    </message>
    <message>
        <source>the wish is no number</source>
        <translation>der Befehl ist keine Zahl</translation>
    </message>
    <message>
        <source>obstacle in {} m</source>
        <translation>Hindernis in {} m</translation>
    </message>
    <message>
        <source>the scan there is {} s old</source>
        <translation>der Scan dort ist {} s alt</translation>
    </message>
    <message>
        <source>not seen there yet</source>
        <translation>dort noch nichts gesehen</translation>
    </message>
    <message>
        <source>roll-over</source>
        <translation>Überschlag</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>aufrecht</translation>
    </message>
    <message>
        <source>about to roll over</source>
        <translation>droht umzukippen</translation>
    </message>
    <message>
        <source>rolled over</source>
        <translation>umgekippt</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>body heat, {} degrees C</source>
        <translation>Körperwärme, {} °C</translation>
    </message>
    <message>
        <source>sticks must be neutral first</source>
        <translation>erst Sticks loslassen</translation>
    </message>
    <message>
        <source>the heat is hidden from here</source>
        <translation>die Wärme ist von hier verdeckt</translation>
    </message>
    <message>
        <source>warm, but no person: no clothes beside the heat</source>
        <translation>warm, aber kein Mensch: keine Kleidung daneben</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotsFeature</name>
    <message>
        <source>Select %1	%2</source>
        <translation>%1 wählen	%2</translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>&amp;Stop all robots	Esc</source>
        <translation>&amp;Alle Roboter anhalten	Esc</translation>
    </message>
    <message>
        <source>All robots stand until each is released</source>
        <translation>Alle Roboter stehen, bis jeder freigegeben ist</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>&amp;Modus</translation>
    </message>
    <message>
        <source>The robot has reported none yet</source>
        <translation>Der Roboter hat noch keinen gemeldet</translation>
    </message>
</context>
<context>
    <name>leitstand::RobotsOnMap</name>
    <message>
        <source>Next way to &amp;follow</source>
        <translation>Nächste Art zu &amp;folgen</translation>
    </message>
    <message>
        <source>The map stands still, follows the selected robot from behind, or from above</source>
        <translation>Die Karte steht still, folgt dem gewählten Roboter von hinten oder von oben</translation>
    </message>
    <message>
        <source>Map stands &amp;still</source>
        <translation>Karte &amp;steht still</translation>
    </message>
    <message>
        <source>The mouse alone moves the map</source>
        <translation>Nur die Maus bewegt die Karte</translation>
    </message>
    <message>
        <source>Follow from be&amp;hind</source>
        <translation>Von h&amp;inten folgen</translation>
    </message>
    <message>
        <source>The camera stays behind and above the selected robot; ceilings are hidden</source>
        <translation>Die Kamera bleibt hinter und über dem gewählten Roboter; Decken sind ausgeblendet</translation>
    </message>
    <message>
        <source>Follow from a&amp;bove</source>
        <translation>Von &amp;oben folgen</translation>
    </message>
    <message>
        <source>The camera stays above the selected robot, its heading up; ceilings are hidden</source>
        <translation>Die Kamera bleibt über dem gewählten Roboter, seine Richtung oben; Decken sind ausgeblendet</translation>
    </message>
    <message>
        <source>What robots &amp;draw</source>
        <translation>Was Roboter &amp;zeichnen</translation>
    </message>
    <message>
        <source>Markers, outlines, detections and places that robots publish, over the map</source>
        <translation>Marker, Umrisse, Erkennungen und Orte, die Roboter veröffentlichen, über der Karte</translation>
    </message>
    <message>
        <source>Robots as their &amp;models</source>
        <translation>Roboter als ihre &amp;Modelle</translation>
    </message>
    <message>
        <source>Robots that publish their model (robot_description) are drawn by it, with their joints; others as symbols</source>
        <translation>Roboter, die ihr Modell veröffentlichen (robot_description), werden danach gezeichnet, mit ihren Gelenken; andere als Symbole</translation>
    </message>
</context>
<context>
    <name>leitstand::ScanDoubt</name>
    <message>
        <source>little overlap</source>
        <translation>wenig Überlappung</translation>
    </message>
    <message>
        <source>Little overlap: few of its points meet the map. Where it shows new ground, accept it if its walls go on in line.</source>
        <translation>Wenig Überlappung: wenige seiner Punkte treffen die Karte. Zeigt er Neuland, annehmen, wenn seine Wände in Flucht weiterlaufen.</translation>
    </message>
    <message>
        <source>bad fit</source>
        <translation>passt schlecht</translation>
    </message>
    <message>
        <source>Bad fit: points that meet the map lie off it. Retry, or reject it.</source>
        <translation>Passt schlecht: Punkte, die die Karte treffen, liegen daneben. Erneut versuchen oder ablehnen.</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Jump: it moved otherwise than the wheels say. They may have slipped: look whether walls double.</source>
        <translation>Sprung: er bewegte sich anders, als die Räder sagen. Vielleicht sind sie durchgedreht: prüfen, ob Wände doppelt erscheinen.</translation>
    </message>
    <message>
        <source>open direction</source>
        <translation>offene Richtung</translation>
    </message>
    <message>
        <source>Open direction: it fits as well when shifted some way, as in a corridor.</source>
        <translation>Offene Richtung: in eine Richtung verschoben passt er ebenso gut, wie in einem Gang.</translation>
    </message>
    <message>
        <source>no end</source>
        <translation>kein Ende</translation>
    </message>
    <message>
        <source>No end: the registration did not settle. Retry with a wider search.</source>
        <translation>Kein Ende: die Registrierung kam nicht zur Ruhe. Mit weiterer Suche erneut versuchen.</translation>
    </message>
    <message>
        <source>no odometry</source>
        <translation>keine Odometrie</translation>
    </message>
    <message>
        <source>No odometry: nobody knows how the robot came there. Retry from a pose that you drag.</source>
        <translation>Keine Odometrie: niemand weiß, wie der Roboter dorthin kam. Erneut versuchen ab einer gezogenen Pose.</translation>
    </message>
    <message>
        <source>too few points</source>
        <translation>zu wenige Punkte</translation>
    </message>
    <message>
        <source>Too few points: reject it, the next scan says more.</source>
        <translation>Zu wenige Punkte: ablehnen, der nächste Scan sagt mehr.</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>uncertain ?</source>
        <translation>unsicher ?</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>beiseite</translation>
    </message>
    <message>
        <source>motion partly guessed</source>
        <translation>Bewegung teils geschätzt</translation>
    </message>
    <message>
        <source>Motion partly guessed: odometry was missing or late within the scan. Look whether its walls are bent.</source>
        <translation>Bewegung teils geschätzt: im Scan fehlte Odometrie oder kam zu spät. Nachsehen, ob seine Wände krumm sind.</translation>
    </message>
</context>
<context>
    <name>leitstand::ScanFeature</name>
    <message>
        <source>&amp;Laser in the virtual scan</source>
        <translation>&amp;Laser im virtuellen Scan</translation>
    </message>
    <message>
        <source>Draws what plane lasers measured, as it came, over the contours of walls and obstacles</source>
        <translation>Zeichnet, was ebene Laserscanner maßen, wie es kam, über die Umrisse von Wänden und Hindernissen</translation>
    </message>
</context>
<context>
    <name>leitstand::ScanListModel</name>
    <message>
        <source>%1 of them used after range limits, filter and voxels</source>
        <translation>%1 davon verwendet nach Reichweite, Filter und Voxeln</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>x y z m</source>
        <translation>x y z m</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Ceiling</source>
        <translation>Decke</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>RMS mm</source>
        <translation>RMS mm</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Gewissheit</translation>
    </message>
    <message>
        <source>Name of the scan; the box shows or hides it</source>
        <translation>Name des Scans; das Kästchen zeigt oder verbirgt ihn</translation>
    </message>
    <message>
        <source>Position in the map: metres forward, left and up of the first scan</source>
        <translation>Position in der Karte: Meter vor, links von und über dem ersten Scan</translation>
    </message>
    <message>
        <source>Heading in the map, to the left of the first scan&apos;s</source>
        <translation>Richtung in der Karte, gegen die des ersten Scans nach links</translation>
    </message>
    <message>
        <source>Points of the scan</source>
        <translation>Punkte des Scans</translation>
    </message>
    <message>
        <source>Share of the labelled points that is floor</source>
        <translation>Anteil der Punkte mit Label, die Boden sind</translation>
    </message>
    <message>
        <source>Share of the labelled points that is wall</source>
        <translation>Anteil der Punkte mit Label, die Wand sind</translation>
    </message>
    <message>
        <source>Share of the labelled points that is ceiling</source>
        <translation>Anteil der Punkte mit Label, die Decke sind</translation>
    </message>
    <message>
        <source>Iterations of the ICP, over all stages</source>
        <translation>Iterationen des ICP, über alle Stufen</translation>
    </message>
    <message>
        <source>Root mean square distance of the point pairs at the end, in millimetres. Says little about the pose: overlap and certainty say more.</source>
        <translation>Quadratisches Mittel der Abstände der Punktpaare am Ende, in Millimetern. Sagt wenig über die Pose: Überlappung und Gewissheit sagen mehr.</translation>
    </message>
    <message>
        <source>Share of the scan&apos;s points with a partner within 10 cm</source>
        <translation>Anteil der Punkte des Scans mit einem Partner innerhalb von 10 cm</translation>
    </message>
    <message>
        <source>Whether the pose is held in every direction, from the smallest eigenvalue of the information matrix</source>
        <translation>Ob die Pose in jeder Richtung gehalten wird, aus dem kleinsten Eigenwert der Informationsmatrix</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>  m</source>
        <translation>  m</translation>
    </message>
    <message>
        <source>Roll pitch heading</source>
        <translation>Rollen Nicken Richtung</translation>
    </message>
    <message>
        <source>%1, used %2</source>
        <translation>%1, verwendet %2</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>Decke</translation>
    </message>
    <message>
        <source>Corrected by</source>
        <translation>Korrigiert um</translation>
    </message>
    <message>
        <source>%1 m, %2</source>
        <translation>%1 m, %2</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>%1 steps in %2 s, RMS %3 mm</source>
        <translation>%1 Schritte in %2 s, RMS %3 mm</translation>
    </message>
    <message>
        <source>Trust</source>
        <translation>Vertrauen</translation>
    </message>
</context>
<context>
    <name>leitstand::ScannerFeature</name>
    <message>
        <source>Co&amp;rrect the scanner as the map says</source>
        <translation>Scanne&amp;r so berichtigen, wie die Karte es sagt</translation>
    </message>
    <message>
        <source>Leave the sca&amp;nner as it is</source>
        <translation>Scan&amp;ner lassen, wie er ist</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Berichtigen</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Lassen</translation>
    </message>
    <message>
        <source>The map finds no scanner to be off</source>
        <translation>Die Karte findet keinen Scanner, der falsch misst</translation>
    </message>
    <message>
        <source>From its next scan on, and in the robot&apos;s file: also when it is connected next time. What is in the map stays</source>
        <translation>Ab seinem nächsten Scan, und in der Datei des Roboters: auch wenn er das nächste Mal verbunden wird. Was in der Karte ist, bleibt</translation>
    </message>
    <message>
        <source>Nothing changes, and it is not asked about again</source>
        <translation>Nichts ändert sich, und danach wird nicht mehr gefragt</translation>
    </message>
    <message>
        <source>%1: its 3D scanner measures %2 too far. Correct that?</source>
        <translation>%1: sein 3D-Scanner misst um %2 zu weit. Berichtigen?</translation>
    </message>
    <message>
        <source>%1: its 3D scanner measures %2 too short. Correct that?</source>
        <translation>%1: sein 3D-Scanner misst um %2 zu kurz. Berichtigen?</translation>
    </message>
    <message>
        <source>%1: its 3D scanner leans, %2 to the %3 and %4 %5, against where it is said to sit. Correct that?</source>
        <translation>%1: sein 3D-Scanner neigt sich um %2 nach %3 und um %4 nach %5, gegenüber dem, wie er sitzen soll. Berichtigen?</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>%1 farther ahead</source>
        <translation>%1 weiter vorn</translation>
    </message>
    <message>
        <source>%1 farther back</source>
        <translation>%1 weiter hinten</translation>
    </message>
    <message>
        <source>%1 farther left</source>
        <translation>%1 weiter links</translation>
    </message>
    <message>
        <source>%1 farther right</source>
        <translation>%1 weiter rechts</translation>
    </message>
    <message>
        <source>turned %1 to the left</source>
        <translation>um %1 nach links gedreht</translation>
    </message>
    <message>
        <source>turned %1 to the right</source>
        <translation>um %1 nach rechts gedreht</translation>
    </message>
    <message>
        <source>%1: the clock of its 3D scanner is %2 ahead of its odometry&apos;s. Correct that?</source>
        <translation>%1: die Uhr des 3D-Scanners geht gegenüber der Odometrie um %2 vor. Berichtigen?</translation>
    </message>
    <message>
        <source>%1: the clock of its 3D scanner is %2 behind its odometry&apos;s. Correct that?</source>
        <translation>%1: die Uhr des 3D-Scanners geht gegenüber der Odometrie um %2 nach. Berichtigen?</translation>
    </message>
    <message>
        <source>%1: its 3D scanner is not mounted as described, but %2. Correct that?</source>
        <translation>%1: sein 3D-Scanner sitzt nicht wie angegeben, sondern %2. Berichtigen?</translation>
    </message>
</context>
<context>
    <name>leitstand::ScansPanel</name>
    <message>
        <source>Scans of the map</source>
        <translation>Scans der Karte</translation>
    </message>
    <message>
        <source>Show all scans</source>
        <translation>Alle Scans zeigen</translation>
    </message>
    <message>
        <source>Hide all scans</source>
        <translation>Alle Scans verbergen</translation>
    </message>
</context>
<context>
    <name>leitstand::ScorePane</name>
    <message>
        <source>More would bring</source>
        <translation>Mehr brächte</translation>
    </message>
    <message>
        <source>Estimate of the score</source>
        <translation>Schätzung der Punkte</translation>
    </message>
    <message>
        <source>An estimate: judges look at the map, which counts as good here</source>
        <translation>Eine Schätzung: die Karte beurteilen Schiedsrichter, hier zählt sie als gut</translation>
    </message>
    <message>
        <source>What each find adds, and what would bring more</source>
        <translation>Was jeder Fund beiträgt, und was mehr brächte</translation>
    </message>
    <message>
        <source>Nothing to score yet: what a find brings is listed here</source>
        <translation>Noch nichts zu werten: hier steht, was ein Fund bringt</translation>
    </message>
</context>
<context>
    <name>leitstand::ScoreText</name>
    <message>
        <source>map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>Geräusch</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>situation</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>tag</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>%1, not confirmed</source>
        <translation>%1, nicht bestätigt</translation>
    </message>
    <message>
        <source> · area × %1</source>
        <translation> · Bereich × %1</translation>
    </message>
    <message>
        <source> · autonomy × %1</source>
        <translation> · Autonomie × %1</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 · version %2</source>
        <translation>%1 · Version %2</translation>
    </message>
    <message>
        <source> · %1 values unconfirmed</source>
        <translation> · %1 Werte unbestätigt</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>noch %1 min</translation>
    </message>
    <message>
        <source>time is over</source>
        <translation>Zeit ist um</translation>
    </message>
    <message>
        <source>%1 × touched the arena</source>
        <translation>%1 × Arena berührt</translation>
    </message>
    <message>
        <source>%1 × touched a victim</source>
        <translation>%1 × Opfer berührt</translation>
    </message>
    <message>
        <source>operators: %1</source>
        <translation>Fahrer: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>V1: heat</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: confirm</source>
        <translation>%1: bestätigen</translation>
    </message>
    <message>
        <source>area “%1” has no weight in these rules</source>
        <translation>Bereich „%1“ hat in diesen Regeln kein Gewicht</translation>
    </message>
</context>
<context>
    <name>leitstand::ScreenWords</name>
    <message>
        <source>somebody sends what is no RTPS: {0} from {1}</source>
        <translation>jemand sendet, was kein RTPS ist: {0} von {1}</translation>
    </message>
    <message>
        <source>somebody sends numbers that no writer can have reached: {0} from {1}</source>
        <translation>jemand sendet Nummern, die kein Sender erreicht haben kann: {0} von {1}</translation>
    </message>
    <message>
        <source>somebody speaks in the name of another participant: {0} from {1}</source>
        <translation>jemand spricht im Namen eines anderen Teilnehmers: {0} von {1}</translation>
    </message>
    <message>
        <source>more participants or endpoints than a computer may have are refused: {0} from {1}</source>
        <translation>mehr Teilnehmer oder Endpunkte, als ein Rechner haben darf, werden abgewiesen: {0} von {1}</translation>
    </message>
    <message>
        <source>somebody who is no participant sends too much: {0} from {1}</source>
        <translation>jemand, der kein Teilnehmer ist, sendet zu viel: {0} von {1}</translation>
    </message>
    <message>
        <source>somebody without keys sends what is not encrypted: {0} from {1}</source>
        <translation>jemand ohne Schlüssel sendet unverschlüsselt: {0} von {1}</translation>
    </message>
    <message>
        <source>one packet</source>
        <translation>ein Paket</translation>
    </message>
    <message>
        <source>{0} packets</source>
        <translation>{0} Pakete</translation>
    </message>
    <message>
        <source>,</source>
        <translation>.</translation>
    </message>
    <message>
        <source>many addresses</source>
        <translation>vielen Adressen</translation>
    </message>
    <message>
        <source>what comes by shared memory is not screened: a program of this computer can bring this one to a halt (the profile file asks for it)</source>
        <translation>was über gemeinsamen Speicher kommt, wird nicht geprüft: Ein Programm dieses Rechners kann dieses hier zum Stehen bringen (die Profildatei verlangt es)</translation>
    </message>
    <message>
        <source>what comes by TCP is not screened: who can connect can bring this program to a halt (the profile file asks for it)</source>
        <translation>was über TCP kommt, wird nicht geprüft: Wer sich verbinden kann, kann dieses Programm zum Stehen bringen (die Profildatei verlangt es)</translation>
    </message>
</context>
<context>
    <name>leitstand::ServiceMenu</name>
    <message>
        <source>Se&amp;rvices</source>
        <translation>&amp;Dienste</translation>
    </message>
    <message>
        <source>%1: on</source>
        <comment>a service that switches something</comment>
        <translation>%1: an</translation>
    </message>
    <message>
        <source>%1: off</source>
        <comment>a service that switches something</comment>
        <translation>%1: aus</translation>
    </message>
    <message>
        <source>%1 has none</source>
        <translation>%1 hat keine</translation>
    </message>
    <message>
        <source>Calls %1</source>
        <translation>Ruft %1 auf</translation>
    </message>
    <message>
        <source>Nobody offers %1 now</source>
        <translation>Niemand bietet %1 gerade an</translation>
    </message>
</context>
<context>
    <name>leitstand::SightLine</name>
    <message>
        <source>the picture is %1 old</source>
        <translation>das Bild ist %1 alt</translation>
    </message>
    <message>
        <source>there is no picture</source>
        <translation>es gibt kein Bild</translation>
    </message>
    <message>
        <source>it is the same picture for %1</source>
        <translation>seit %1 dasselbe Bild</translation>
    </message>
    <message>
        <source>the scan of the way is %1 old</source>
        <translation>der Scan des Weges ist %1 alt</translation>
    </message>
    <message>
        <source>there is no scan of the way</source>
        <translation>es gibt keinen Scan des Weges</translation>
    </message>
    <message>
        <source>no camera, no scanner: you must see it</source>
        <translation>keine Kamera, kein Scanner: nur mit Blickkontakt</translation>
    </message>
    <message>
        <source>override: driving without eyes · %1</source>
        <translation>überbrückt: Fahrt ohne Sicht · %1</translation>
    </message>
    <message>
        <source>override held: nothing caps the speed</source>
        <translation>überbrückt: nichts begrenzt das Tempo</translation>
    </message>
    <message>
        <source>%1: drive by the virtual scan</source>
        <translation>%1: nach dem virtuellen Scan fahren</translation>
    </message>
    <message>
        <source>creep speed: %1</source>
        <translation>Kriechtempo: %1</translation>
    </message>
    <message>
        <source>held: %1 · hold G to drive without eyes</source>
        <translation>gehalten: %1 · G halten, um ohne Sicht zu fahren</translation>
    </message>
    <message>
        <source>override: driving without eyes</source>
        <translation>überbrückt: Fahrt ohne Sicht</translation>
    </message>
    <message>
        <source>override</source>
        <translation>überbrückt</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>creep speed</source>
        <translation>Kriechtempo</translation>
    </message>
    <message>
        <source>full speed</source>
        <translation>volles Tempo</translation>
    </message>
</context>
<context>
    <name>leitstand::Station</name>
    <message>
        <source>{} has no guard and is not driven: {}</source>
        <translation>{} hat keinen Wächter und wird nicht gefahren: {}</translation>
    </message>
    <message>
        <source>{} is not in the map yet: nothing was filed</source>
        <translation>{} ist noch nicht in der Karte: nichts wurde erfasst</translation>
    </message>
    <message>
        <source>no range there: filed ahead of the robot; move it on the map</source>
        <translation>dort ist keine Entfernung gemessen: vor dem Roboter erfasst; auf der Karte verschieben</translation>
    </message>
    <message>
        <source>{} has new evidence: press again to confirm</source>
        <translation>{} hat neue Belege: noch einmal drücken bestätigt</translation>
    </message>
    <message>
        <source>{} filed: press again to confirm</source>
        <translation>{} erfasst: noch einmal drücken bestätigt</translation>
    </message>
    <message>
        <source>there is nothing on finds to take back</source>
        <translation>an Funden ist nichts zurückzunehmen</translation>
    </message>
    <message>
        <source>Snapshot kept: {}</source>
        <translation>Aufnahme gesichert: {}</translation>
    </message>
    <message>
        <source>its laser fits the map again</source>
        <translation>sein Laser passt wieder zur Karte</translation>
    </message>
    <message>
        <source>its place in the map is doubted</source>
        <translation>sein Ort in der Karte ist fraglich</translation>
    </message>
    <message>
        <source>found in the map</source>
        <translation>in der Karte gefunden</translation>
    </message>
    <message>
        <source>not found beside the other robot: put it to where it stands, or let the other one see it</source>
        <translation>nicht neben dem anderen Roboter gefunden: dorthin setzen, wo er steht, oder den anderen ihn sehen lassen</translation>
    </message>
    <message>
        <source>not found there</source>
        <translation>dort nicht gefunden</translation>
    </message>
    <message>
        <source>the map is another station&apos;s: ask it for the map, or wait until it is silent</source>
        <translation>die Karte gehört einer anderen Station: sie um die Karte bitten oder warten, bis sie schweigt</translation>
    </message>
    <message>
        <source>rewind: no scan entered the map after that moment</source>
        <translation>Zurückspulen: danach kam kein Scan in die Karte</translation>
    </message>
    <message>
        <source>nothing to be taken back: no decision on the map stands</source>
        <translation>nichts zurückzunehmen: keine Entscheidung zur Karte gilt</translation>
    </message>
    <message>
        <source>nothing to be done again: nothing was taken back last</source>
        <translation>nichts zu wiederholen: zuletzt wurde nichts zurückgenommen</translation>
    </message>
    <message>
        <source>there is no map yet to put a robot into</source>
        <translation>es gibt noch keine Karte, in die ein Roboter gesetzt werden könnte</translation>
    </message>
    <message>
        <source>{}: there are no key scans that could be registered again</source>
        <translation>{}: keine Schlüsselscans, die neu registriert werden könnten</translation>
    </message>
    <message>
        <source>Cameras looked from more places than can be kept: what they look at from now on may not count as searched</source>
        <translation>Kameras sahen von mehr Orten aus, als behalten werden können: was sie von nun an sehen, zählt womöglich nicht als abgesucht</translation>
    </message>
    <message>
        <source>This computer is too slow for all that cameras look at: some of it does not count as searched</source>
        <translation>Dieser Rechner ist zu langsam für alles, was Kameras sehen: manches davon zählt nicht als abgesucht</translation>
    </message>
    <message>
        <source>{}: the mission has no such find to change so</source>
        <translation>{}: die Mission hat keinen solchen Fund</translation>
    </message>
    <message>
        <source>the mission has no such candidate</source>
        <translation>die Mission hat keinen solchen Kandidaten</translation>
    </message>
    <message>
        <source>a note without words is none</source>
        <translation>eine Notiz ohne Worte ist keine</translation>
    </message>
    <message>
        <source>{}: the mission has no {}</source>
        <translation>{}: die Mission hat kein {}</translation>
    </message>
    <message>
        <source>its laser sees too little: {} points</source>
        <translation>sein Laser sieht zu wenig: {} Punkte</translation>
    </message>
    <message>
        <source>its laser sees too little</source>
        <translation>sein Laser sieht zu wenig</translation>
    </message>
    <message>
        <source>too little of what it sees is in the map</source>
        <translation>zu wenig von dem, was er sieht, ist in der Karte</translation>
    </message>
    <message>
        <source>only {} % of what it sees is in the map</source>
        <translation>nur {} % von dem, was er sieht, ist in der Karte</translation>
    </message>
    <message>
        <source>{} % of what it sees is in the map</source>
        <translation>{} % von dem, was er sieht, ist in der Karte</translation>
    </message>
    <message>
        <source>{} % of what its laser sees is in the map</source>
        <translation>{} % von dem, was sein Laser sieht, ist in der Karte</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>{} % of what it sees is in the map, {} cm and {} degrees from the guess</source>
        <translation>{} % von dem, was er sieht, ist in der Karte, {} cm und {} Grad neben der Schätzung</translation>
    </message>
    <message>
        <source>the walls leave a direction open</source>
        <translation>die Wände lassen eine Richtung offen</translation>
    </message>
    <message>
        <source>it could as well stand elsewhere</source>
        <translation>er könnte ebenso gut anderswo stehen</translation>
    </message>
    <message>
        <source>its laser fits {} cm from where its tracks say</source>
        <translation>sein Laser passt {} cm neben dem, was die Ketten sagen</translation>
    </message>
    <message>
        <source>found again: {}</source>
        <translation>wiedergefunden: {}</translation>
    </message>
    <message>
        <source>{} sees it: {} % of what its laser sees there is in the map</source>
        <translation>{} sieht ihn: {} % von dem, was sein Laser dort sieht, ist in der Karte</translation>
    </message>
    <message>
        <source>it would see things where the map has none</source>
        <translation>er sähe Dinge, wo die Karte keine hat</translation>
    </message>
    <message>
        <source>put there by the operator; its laser says nothing</source>
        <translation>vom Operator dorthin gesetzt; sein Laser sagt nichts</translation>
    </message>
    <message>
        <source>put there by the operator; its next scan tells where it stands</source>
        <translation>vom Operator dorthin gesetzt; sein nächster Scan zeigt, wo er steht</translation>
    </message>
    <message>
        <source>its scan fits the map</source>
        <translation>sein Scan passt zur Karte</translation>
    </message>
    <message>
        <source>its scan does not fit</source>
        <translation>sein Scan passt nicht</translation>
    </message>
    <message>
        <source>its newest key scan</source>
        <translation>sein neuester Schlüsselscan</translation>
    </message>
    <message>
        <source>put there by the operator, but {}</source>
        <translation>vom Operator dorthin gesetzt, aber {}</translation>
    </message>
    <message>
        <source>where it was when the station was left: {}</source>
        <translation>wo er war, als die Station verlassen wurde: {}</translation>
    </message>
    <message>
        <source>where it was when the station was left</source>
        <translation>wo er war, als die Station verlassen wurde</translation>
    </message>
    <message>
        <source>its odometry began anew</source>
        <translation>seine Odometrie begann neu</translation>
    </message>
    <message>
        <source>no station made a map of this mission: {} of its {} scans were registered for the review, without anyone&apos;s check</source>
        <translation>keine Station hat eine Karte dieser Mission gemacht: {} ihrer {} Scans wurden für die Durchsicht registriert, ohne dass jemand sie geprüft hat</translation>
    </message>
    <message>
        <source>{}: no station of ours recorded it, so that it stays as it is; nothing can be written into it</source>
        <translation>{}: keine Leitstand-Station hat sie aufgezeichnet, deshalb bleibt sie, wie sie ist; nichts kann hineingeschrieben werden</translation>
    </message>
    <message>
        <source>key scan {}: expected one of the map</source>
        <translation>Schlüsselscan {}: erwartet wird einer der Karte</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is none of the station&apos;s robots</source>
        <translation>„{}“ ist kein Roboter dieser Station</translation>
    </message>
    <message>
        <source>{}: its file names no stream_command stream</source>
        <translation>{}: seine Datei nennt keinen stream_command-Strom</translation>
    </message>
    <message>
        <source>{}: {} is none of the streams that it sends</source>
        <translation>{}: {} ist keiner der Ströme, die er sendet</translation>
    </message>
    <message>
        <source>Nothing is filed that could be confirmed: F files what the robot sees</source>
        <translation>Nichts ist erfasst, das bestätigt werden könnte: F erfasst, was der Roboter sieht</translation>
    </message>
    <message>
        <source>nothing was scanned there: point to it on the map</source>
        <translation>dort wurde nichts gescannt: auf der Karte anklicken</translation>
    </message>
    <message>
        <source>the robot was not in the map then: nothing was filed</source>
        <translation>der Roboter war da nicht in der Karte: nichts wurde erfasst</translation>
    </message>
    <message>
        <source>another station makes another map than this mission&apos;s (their scans {} differ): it is not shown here; begin a new mission to see it</source>
        <translation>eine andere Station macht eine andere Karte als die dieses Einsatzes (ihre Scans {} sind verschieden): sie wird hier nicht gezeigt; ein neuer Einsatz zeigt sie</translation>
    </message>
    <message>
        <source>{} of another station was found first: this station&apos;s {} is {} now</source>
        <translation>{} einer anderen Station wurde zuerst gefunden: {} dieser Station ist jetzt {}</translation>
    </message>
    <message>
        <source>nothing was written in reviews that could be taken back</source>
        <translation>in Auswertungen wurde nichts geschrieben, das sich zurücknehmen ließe</translation>
    </message>
    <message>
        <source>{} is sent nowhere during its brake test</source>
        <translation>{} wird während des Bremstests nirgendwohin geschickt</translation>
    </message>
    <message>
        <source>{} failed its brake test: it is sent nowhere until it passes or is driven nevertheless</source>
        <translation>{} hat den Bremstest nicht bestanden: wird nirgendwohin geschickt, bis er besteht oder dennoch gefahren wird</translation>
    </message>
    <message>
        <source>{} has new evidence; it is confirmed already</source>
        <translation>{} hat neue Belege; schon bestätigt</translation>
    </message>
    <message>
        <source>the mission&apos;s log does not answer: it is not known whether this was written</source>
        <translation>das Protokoll der Mission antwortet nicht: ob dies geschrieben wurde, ist nicht bekannt</translation>
    </message>
    <message>
        <source>a closed loop contradicts the rest of the map: it does not count any more</source>
        <translation>eine geschlossene Schleife widerspricht der übrigen Karte: Sie zählt nicht mehr</translation>
    </message>
    <message>
        <source>the map meets itself: its parts moved by up to {} m</source>
        <translation>die Karte trifft sich selbst: Ihre Teile rückten um bis zu {} m</translation>
    </message>
    <message>
        <source>nothing to be taken back: no loop closed</source>
        <translation>nichts zurückzunehmen: Keine Schleife hat sich geschlossen</translation>
    </message>
    <message>
        <source>is this a place that was seen before? The map is farther off here than expected: say whether it is the same place</source>
        <translation>wurde diese Stelle schon einmal gesehen? Die Karte liegt hier weiter daneben als erwartet: Sagen Sie, ob es dieselbe Stelle ist</translation>
    </message>
    <message>
        <source>nothing is asked about the map</source>
        <translation>zur Karte ist nichts gefragt</translation>
    </message>
    <message>
        <source>{}: expected a map of ours, found no key scans</source>
        <translation>{}: eine Karte von uns erwartet, keine Schlüsselscans gefunden</translation>
    </message>
    <message>
        <source>cancelled: the map is as it was</source>
        <translation>abgebrochen: die Karte ist, wie sie war</translation>
    </message>
    <message>
        <source>{}: its map was not tidied</source>
        <translation>{}: die Karte wurde nicht aufgeräumt</translation>
    </message>
    <message>
        <source>{}: expected the mission&apos;s folder</source>
        <translation>{}: der Ordner der Mission wird erwartet</translation>
    </message>
    <message>
        <source>{}: somebody wrote into it meanwhile; try again</source>
        <translation>{}: inzwischen hat jemand hineingeschrieben; noch einmal versuchen</translation>
    </message>
    <message>
        <source>{}: the tidied map went on since; it stays</source>
        <translation>{}: die aufgeräumte Karte ging seither weiter; sie bleibt</translation>
    </message>
    <message>
        <source>{} places of the map look like where it is: put it to where it stands</source>
        <translation>{} Stellen der Karte sehen aus wie dort, wo er ist: ihn dorthin setzen, wo er steht</translation>
    </message>
    <message>
        <source>no place of the map fits its newest 3D scan for sure: put it to where it stands</source>
        <translation>sein neuester 3D-Scan passt nirgends sicher in die Karte: ihn dorthin setzen, wo er steht</translation>
    </message>
    <message>
        <source>found in the whole map, where {} % of what it sees fits; its next scan tells whether it stands there</source>
        <translation>in der ganzen Karte gefunden, wo {} % von dem passen, was er sieht; sein nächster Scan sagt, ob er dort steht</translation>
    </message>
    <message>
        <source>scan {}: expected one that counts: accept it first</source>
        <translation>Scan {}: erwartet wird einer, der zählt: Zuerst annehmen</translation>
    </message>
    <message>
        <source>scan {} does not fit there: draw it nearer to where it was, or it is another place</source>
        <translation>Scan {} passt dort nicht: Näher an die richtige Stelle ziehen, oder es ist eine andere</translation>
    </message>
    <message>
        <source>scan {}: no older part of the map is within {} m of there</source>
        <translation>Scan {}: Kein älterer Teil der Karte liegt dort im Umkreis von {} m</translation>
    </message>
    <message>
        <source>the map is tidy: nothing moved, nothing was written</source>
        <translation>die Karte ist aufgeräumt: Nichts bewegte sich, nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>the map is tidied: {} of {} scans moved, by up to {} m</source>
        <translation>die Karte ist aufgeräumt: {} von {} Scans bewegten sich, um bis zu {} m</translation>
    </message>
    <message>
        <source>; {} links of loops contradict the rest and do not count any more</source>
        <translation>; {} Verbindungen von Schleifen widersprechen dem Rest und zählen nicht mehr</translation>
    </message>
    <message>
        <source>the map asks about another place by now: look at it again</source>
        <translation>die Karte fragt inzwischen nach einer anderen Stelle: noch einmal ansehen</translation>
    </message>
    <message>
        <source>the map is as it was before it was tidied</source>
        <translation>die Karte ist, wie sie vor dem Aufräumen war</translation>
    </message>
    <message>
        <source>{}: what its 3D scanner measures does not fit together: say whether it is to be corrected</source>
        <translation>{}: was sein 3D-Scanner misst, passt nicht zusammen: sagen Sie, ob es berichtigt werden soll</translation>
    </message>
    <message>
        <source>{}: its 3D scanner is corrected from its next scan on</source>
        <translation>{}: sein 3D-Scanner wird ab dem nächsten Scan berichtigt</translation>
    </message>
    <message>
        <source>, and from now on by its file {}</source>
        <translation>, und von nun an durch seine Datei {}</translation>
    </message>
    <message>
        <source>nothing is asked about the scanner any more</source>
        <translation>zum Scanner wird nichts mehr gefragt</translation>
    </message>
    <message>
        <source>two parts of the map seem to have seen the same place: say whether they did</source>
        <translation>zwei Teile der Karte haben anscheinend denselben Ort gesehen: sagen Sie, ob es so ist</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>it maps a part of its own, which has not met the rest yet</source>
        <translation>er kartiert einen eigenen Teil, der den Rest noch nicht getroffen hat</translation>
    </message>
    <message>
        <source>{}: it is there already: a map is carried into a new mission</source>
        <translation>{}: gibt es schon: eine Karte wird nur in eine neue Mission übernommen</translation>
    </message>
    <message>
        <source>{}: a map is merged with that of another mission</source>
        <translation>{}: eine Karte wird mit der einer anderen Mission verbunden</translation>
    </message>
    <message>
        <source>the map is tidy: nothing moved; its scans are held together by {} links now</source>
        <translation>die Karte ist in Ordnung: nichts hat sich bewegt; ihre Scans halten jetzt {} Verknüpfungen zusammen</translation>
    </message>
    <message>
        <source>it does not fit the rest of the map there: move it nearer to where it belongs, or snap it first</source>
        <translation>es passt dort nicht zum Rest der Karte: Schieben Sie es näher dorthin, wo es hingehört, oder lassen Sie es erst einrasten</translation>
    </message>
    <message>
        <source>{}: nothing tells how its scans hang together: tidy the map first</source>
        <translation>{}: Nichts sagt, wie ihre Scans zusammenhängen: Räumen Sie die Karte zuerst auf</translation>
    </message>
    <message>
        <source>{}: its map is made from {}; its other clouds are shown, and used for obstacles</source>
        <translation>{}: seine Karte entsteht aus {}; seine anderen Punktwolken werden gezeigt und für Hindernisse genutzt</translation>
    </message>
    <message>
        <source>{}: its plane laser {} makes the map</source>
        <translation>{}: sein ebener Laser {} macht die Karte</translation>
    </message>
    <message>
        <source>{}: expected a topic of its scanners, found {}</source>
        <translation>{}: erwartet wurde ein Topic seiner Scanner, gefunden wurde {}</translation>
    </message>
    <message>
        <source>{} is stopped: it is sent nowhere before its release</source>
        <translation>{} ist gestoppt: vor der Freigabe wird er nirgendwohin geschickt</translation>
    </message>
    <message>
        <source>{} on</source>
        <translation>{} an</translation>
    </message>
    <message>
        <source>{} off</source>
        <translation>{} aus</translation>
    </message>
    <message>
        <source>{}: no answer</source>
        <translation>{}: keine Antwort</translation>
    </message>
    <message>
        <source>{}: done</source>
        <translation>{}: erledigt</translation>
    </message>
    <message>
        <source>{}: done ({})</source>
        <translation>{}: erledigt ({})</translation>
    </message>
    <message>
        <source>{}: refused</source>
        <translation>{}: abgelehnt</translation>
    </message>
    <message>
        <source>{}: refused ({})</source>
        <translation>{}: abgelehnt ({})</translation>
    </message>
    <message>
        <source>{}: another station has its drive control</source>
        <translation>{}: Eine andere Station hat das Fahrrecht</translation>
    </message>
</context>
<context>
    <name>leitstand::StickGauge</name>
    <message>
        <source>Tick: the stick as it is held; shade: dead zone; bar: what comes of it</source>
        <translation>Strich: der Stick, wie er gehalten wird; Schatten: Totzone; Balken: was daraus wird</translation>
    </message>
    <message>
        <source>%1 and opposite</source>
        <translation>%1 und Gegenrichtung</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>leitstand::StopButton</name>
    <message>
        <source>STOP ALL</source>
        <translation>STOP ALLE</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Stop all robots</source>
        <translation>Alle Roboter anhalten</translation>
    </message>
    <message>
        <source>Stops all robots and holds them until each is released (Esc, always and everywhere).
A function of this program, no certified emergency stop.</source>
        <translation>Hält alle Roboter an, bis jeder freigegeben ist (Esc, immer und überall).
Eine Funktion dieses Programms, kein zertifizierter Not-Halt.</translation>
    </message>
</context>
<context>
    <name>leitstand::StopLine</name>
    <message>
        <source>held by zeros</source>
        <translation>durch Nullen gehalten</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>sent · no answer for %1</source>
        <translation>gesendet · ohne Antwort %1</translation>
    </message>
    <message>
        <source>confirmed · moves</source>
        <translation>quittiert · bewegt sich</translation>
    </message>
    <message>
        <source>confirmed · motion unknown</source>
        <translation>quittiert · Bewegung unbekannt</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>releasing</source>
        <translation>gibt frei</translation>
    </message>
    <message>
        <source>The release did nothing: %1</source>
        <translation>Die Freigabe blieb ohne Wirkung: %1</translation>
    </message>
    <message>
        <source>The robot knows no stops: it is held by drive commands of zero.</source>
        <translation>Der Roboter kennt kein STOP: er wird durch Fahrbefehle null gehalten.</translation>
    </message>
    <message>
        <source>Stopped by the robot&apos;s own button.</source>
        <translation>Durch den eigenen Knopf des Roboters gestoppt.</translation>
    </message>
    <message>
        <source>Stopped by another station.</source>
        <translation>Von einer anderen Station gestoppt.</translation>
    </message>
    <message>
        <source>Only the station with drive control can release it.</source>
        <translation>Freigeben kann nur, wer das Fahrrecht hat.</translation>
    </message>
    <message>
        <source>? %1</source>
        <comment>a stop, not answered for 4.2 s</comment>
        <translation>? %1</translation>
    </message>
    <message>
        <source>&gt; 1 h</source>
        <translation>&gt; 1 h</translation>
    </message>
    <message>
        <source>held</source>
        <comment>by zeros</comment>
        <translation>Nullen</translation>
    </message>
    <message>
        <source>sent</source>
        <comment>where there is little room</comment>
        <translation>sendet</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>fährt</translation>
    </message>
    <message>
        <source>moves?</source>
        <translation>fährt?</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>release</source>
        <comment>is on its way</comment>
        <translation>frei</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The robot knows no stops: it is held by drive commands of zero and by its lock.</source>
        <translation>Der Roboter kennt kein STOP: Fahrbefehle von null und seine Sperre halten ihn.</translation>
    </message>
    <message>
        <source>The robot knows no stops: it is held by drive commands of zero. Nobody listens to its lock.</source>
        <translation>Der Roboter kennt kein STOP: Fahrbefehle von null halten ihn. Niemand hört auf seine Sperre.</translation>
    </message>
    <message>
        <source>%1 refuses.</source>
        <translation>%1 weigert sich.</translation>
    </message>
    <message>
        <source>%1 refuses: %2.</source>
        <comment>a service, its own words</comment>
        <translation>%1 weigert sich: %2.</translation>
    </message>
    <message>
        <source>%1 has not confirmed yet.</source>
        <translation>%1 hat noch nicht bestätigt.</translation>
    </message>
    <message>
        <source>Nobody offers %1.</source>
        <translation>Niemand bietet %1 an.</translation>
    </message>
    <message>
        <source>%1 has not released yet.</source>
        <translation>%1 hat noch nicht freigegeben.</translation>
    </message>
    <message>
        <source>%1 confirmed it.</source>
        <translation>%1 hat bestätigt.</translation>
    </message>
    <message>
        <source>%1 cannot be called: %2.</source>
        <comment>a service, why</comment>
        <translation>%1 lässt sich nicht aufrufen: %2.</translation>
    </message>
    <message>
        <source>%1 services confirmed it.</source>
        <translation>%1 Dienste haben bestätigt.</translation>
    </message>
</context>
<context>
    <name>leitstand::StoreyRow</name>
    <message>
        <source>Storeys of the map</source>
        <translation>Stockwerke der Karte</translation>
    </message>
    <message>
        <source>Storey %1, its floor at %2 m</source>
        <translation>Stockwerk %1, sein Boden auf %2 m</translation>
    </message>
    <message>
        <source>All</source>
        <comment>storeys</comment>
        <translation>Alle</translation>
    </message>
    <message>
        <source>All storeys</source>
        <translation>Alle Stockwerke</translation>
    </message>
</context>
<context>
    <name>leitstand::StoreysFeature</name>
    <message>
        <source>What is above and below that storey is not shown</source>
        <translation>Was über und unter diesem Stockwerk liegt, wird nicht gezeigt</translation>
    </message>
    <message>
        <source>Store&amp;y above</source>
        <translation>Stockwerk dar&amp;über</translation>
    </message>
    <message>
        <source>Storey belo&amp;w</source>
        <translation>Stockwerk dar&amp;unter</translation>
    </message>
    <message>
        <source>The map has one storey only</source>
        <translation>Die Karte hat nur ein Stockwerk</translation>
    </message>
</context>
<context>
    <name>leitstand::StreamList</name>
    <message>
        <source>Streams of all robots</source>
        <translation>Datenströme aller Roboter</translation>
    </message>
</context>
<context>
    <name>leitstand::StreamTable</name>
    <message>
        <source>Stream</source>
        <translation>Datenstrom</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Rate Hz</source>
        <translation>Rate Hz</translation>
    </message>
    <message>
        <source>kbit/s</source>
        <translation>kbit/s</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Loss</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Samples a second as they come, and as the robot makes them</source>
        <translation>Werte je Sekunde, wie sie ankommen und wie der Roboter sie erzeugt</translation>
    </message>
    <message>
        <source>What the stream takes of the link, without what is sent again</source>
        <translation>Was der Datenstrom vom Funk beansprucht, ohne erneut Gesendetes</translation>
    </message>
    <message>
        <source>Since the newest sample arrived</source>
        <translation>Seit der neueste Wert ankam</translation>
    </message>
    <message>
        <source>Samples of the last 10 s that never arrived</source>
        <translation>Werte der letzten 10 s, die nie ankamen</translation>
    </message>
    <message>
        <source>What the station asks of the stream; nothing: as the robot likes</source>
        <translation>Was die Station vom Datenstrom verlangt; nichts: nach Wahl des Roboters</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on change</source>
        <translation>bei Änderung</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>quality %1</source>
        <translation>Qualität %1</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>thin: %1</source>
        <translation>gespart: %1</translation>
    </message>
    <message>
        <source> · not yet</source>
        <translation> · noch nicht</translation>
    </message>
    <message>
        <source>%1 of %2 Mbit/s</source>
        <translation>%1 von %2 Mbit/s</translation>
    </message>
    <message>
        <source>%1 Mbit/s</source>
        <translation>%1 Mbit/s</translation>
    </message>
    <message>
        <source>%1 (map)</source>
        <translation>%1 (Karte)</translation>
    </message>
</context>
<context>
    <name>leitstand::SubmapFeature</name>
    <message>
        <source>Move a part of the map by &amp;hand</source>
        <translation>Einen Teil der Karte von &amp;Hand schieben</translation>
    </message>
    <message>
        <source>Move &amp;more of the map, or less</source>
        <translation>&amp;Mehr von der Karte schieben, oder weniger</translation>
    </message>
    <message>
        <source>&amp;Snap the moved part</source>
        <translation>Den geschobenen Teil ein&amp;rasten lassen</translation>
    </message>
    <message>
        <source>Lays the moved part onto the rest of the map, from where it is</source>
        <translation>Legt den geschobenen Teil von dort, wo er ist, auf den Rest der Karte</translation>
    </message>
    <message>
        <source>&amp;Leave the moved part there</source>
        <translation>Den geschobenen Teil dort &amp;lassen</translation>
    </message>
    <message>
        <source>Its scans are linked with those that they lie on, and the map follows</source>
        <translation>Seine Scans werden mit denen verknüpft, auf denen sie liegen, und die Karte folgt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Einrasten</translation>
    </message>
    <message>
        <source>Leave there</source>
        <translation>Dort lassen</translation>
    </message>
    <message>
        <source>There is no part of the map that could be moved against the rest</source>
        <translation>Es gibt keinen Teil der Karte, der gegen den Rest geschoben werden könnte</translation>
    </message>
    <message>
        <source>Drag: moves the violet part · Shift+drag: turns it · right button: not at all</source>
        <translation>Ziehen: schiebt den violetten Teil · Umschalt+Ziehen: dreht ihn · rechte Taste: gar nicht</translation>
    </message>
    <message>
        <source>No other part of the map could be moved against the rest</source>
        <translation>Kein anderer Teil der Karte könnte gegen den Rest geschoben werden</translation>
    </message>
    <message>
        <source>Too little of it lies on the rest of the map there: drag it nearer first</source>
        <translation>Zu wenig davon liegt dort auf dem Rest der Karte: Ziehen Sie ihn erst näher</translation>
    </message>
    <message>
        <source>The map has changed: what was moved is not there any more</source>
        <translation>Die Karte hat sich geändert: Was geschoben wurde, ist nicht mehr da</translation>
    </message>
    <message>
        <source>%1 from scan %2 on (scans: %3)</source>
        <translation>%1 ab Scan %2 (Scans: %3)</translation>
    </message>
    <message>
        <source>all of %1 (scans: %2)</source>
        <translation>alles von %1 (Scans: %2)</translation>
    </message>
    <message>
        <source>the storey of scan %1 (scans: %2)</source>
        <translation>das Stockwerk von Scan %1 (Scans: %2)</translation>
    </message>
    <message>
        <source>the part of the map with scan %1 (scans: %2)</source>
        <translation>der Teil der Karte mit Scan %1 (Scans: %2)</translation>
    </message>
    <message>
        <source>It is laid onto the rest of the map…</source>
        <translation>Er wird auf den Rest der Karte gelegt…</translation>
    </message>
    <message>
        <source>It is made ready…</source>
        <translation>Er wird vorbereitet…</translation>
    </message>
    <message>
        <source>Nothing of the rest of the map is there</source>
        <translation>Dort ist nichts vom Rest der Karte</translation>
    </message>
    <message>
        <source>On the rest of the map: %1, seam %2 m</source>
        <translation>Auf dem Rest der Karte: %1, Naht %2 m</translation>
    </message>
    <message>
        <source>Another station makes the map: it is moved there</source>
        <translation>Eine andere Station macht die Karte: Dort wird sie geschoben</translation>
    </message>
    <message>
        <source>Left there; links to the rest of the map: %1</source>
        <translation>Dort gelassen; Verknüpfungen mit dem Rest der Karte: %1</translation>
    </message>
    <message>
        <source>A run of scans, a robot&apos;s, a storey, a part that has not met the rest, or one scan alone: drag it to where it belongs, Shift+drag turns it</source>
        <translation>Scans einer Strecke, eines Roboters, ein Stockwerk, ein Teil, der den Rest noch nicht getroffen hat, oder ein Scan allein: Ziehen Sie ihn dorthin, wo er hingehört; Umschalt+Ziehen dreht ihn</translation>
    </message>
    <message>
        <source>From the chosen scan on, all of its robot, its storey, its part of the map, this scan alone</source>
        <translation>Vom gewählten Scan an, alles von seinem Roboter, sein Stockwerk, sein Teil der Karte, dieser Scan allein</translation>
    </message>
    <message>
        <source>scan %1 of %2 alone</source>
        <translation>Scan %1 von %2 allein</translation>
    </message>
</context>
<context>
    <name>leitstand::ThermalOverlay</name>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 person?</source>
        <translation>%1 Person?</translation>
    </message>
    <message>
        <source>person?</source>
        <translation>Person?</translation>
    </message>
</context>
<context>
    <name>leitstand::TidyingFeature</name>
    <message>
        <source>T&amp;idy the map</source>
        <translation>Karte auf&amp;räumen</translation>
    </message>
    <message>
        <source>Matches all scans that overlap, whenever they were taken, and moves them together, which takes a while; the review is opened again then. What was recorded stays as it is, and it can be taken back</source>
        <translation>Bringt alle Scans zusammen, die sich überlappen, wann immer sie entstanden, was eine Weile dauert; danach wird die Auswertung neu geöffnet. Was aufgezeichnet wurde, bleibt, wie es ist, und es kann zurückgenommen werden</translation>
    </message>
    <message>
        <source>Take the tidying &amp;back</source>
        <translation>Aufräumen &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>Scans are where they were before the map was tidied; the review is opened again then</source>
        <translation>Scans sind, wo sie vor dem Aufräumen waren; danach wird die Auswertung neu geöffnet</translation>
    </message>
    <message>
        <source>Sho&amp;w the map before the tidying</source>
        <translation>Karte &amp;vor dem Aufräumen zeigen</translation>
    </message>
    <message>
        <source>In violet: where scans lay before the map was tidied</source>
        <translation>Violett: wo Scans lagen, bevor die Karte aufgeräumt wurde</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>A report is being written, or scans are being registered again: tidy the map after that</source>
        <translation>Ein Bericht wird geschrieben, oder Scans werden neu registriert: Die Karte danach aufräumen</translation>
    </message>
    <message>
        <source>Violet: the map before it was tidied. Scans moved: %1, by up to %2 m.</source>
        <translation>Violett: die Karte, bevor sie aufgeräumt wurde. Verschobene Scans: %1, um bis zu %2 m.</translation>
    </message>
</context>
<context>
    <name>leitstand::Timeline</name>
    <message>
        <source>%1 confirmed</source>
        <translation>%1 bestätigt</translation>
    </message>
    <message>
        <source>%1 discarded</source>
        <translation>%1 verworfen</translation>
    </message>
    <message>
        <source>%1 filed</source>
        <translation>%1 erfasst</translation>
    </message>
    <message>
        <source>a victim</source>
        <translation>ein Opfer</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>Geräusch</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>a code</source>
        <translation>einen Code</translation>
    </message>
    <message>
        <source>a hazard sign</source>
        <translation>ein Gefahrzeichen</translation>
    </message>
    <message>
        <source>the robot saw %1</source>
        <translation>der Roboter sah %1</translation>
    </message>
    <message>
        <source>the robot saw %1: %2</source>
        <translation>der Roboter sah %1: %2</translation>
    </message>
    <message>
        <source>alarm: %1</source>
        <translation>Alarm: %1</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>Notiz: %1</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>rückgängig</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>rückgängig: %1</translation>
    </message>
    <message>
        <source>decision on scans</source>
        <translation>Entscheidung über Scans</translation>
    </message>
    <message>
        <source>mode: %1</source>
        <translation>Modus: %1</translation>
    </message>
    <message>
        <source>mode: %1 (%2)</source>
        <translation>Modus: %1 (%2)</translation>
    </message>
    <message>
        <source>bumped: %1</source>
        <translation>angestoßen: %1</translation>
    </message>
    <message>
        <source>recording ended (%1)</source>
        <translation>Aufzeichnung endete (%1)</translation>
    </message>
    <message>
        <source>recording began (%1)</source>
        <translation>Aufzeichnung begann (%1)</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>backwards %1</source>
        <translation>rückwärts %1</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>the robot&apos;s own sighting</source>
        <translation>eigene Sichtung des Roboters</translation>
    </message>
    <message>
        <source>candidate dismissed: %1</source>
        <translation>Kandidat verworfen: %1</translation>
    </message>
    <message>
        <source>candidate: %1, %2</source>
        <comment>a victim, 72 %</comment>
        <translation>Kandidat: %1, %2</translation>
    </message>
    <message>
        <source>%1 moved %2 m, since %3 (%4)</source>
        <translation>%1 um %2 m bewegt, weil %3 (%4)</translation>
    </message>
    <message>
        <source>done again</source>
        <translation>wiederhergestellt</translation>
    </message>
    <message>
        <source>done again: %1</source>
        <translation>wiederhergestellt: %1</translation>
    </message>
    <message>
        <source>a victim&apos;s tag</source>
        <translation>das Schild eines Opfers</translation>
    </message>
</context>
<context>
    <name>leitstand::TimelineBar</name>
    <message>
        <source>Timeline of the mission</source>
        <translation>Zeitleiste der Mission</translation>
    </message>
    <message>
        <source>Click or drag to go to a moment; arrows step by 1 s, with Shift by 10 s</source>
        <translation>Klicken oder ziehen, um zu einem Zeitpunkt zu gehen; Pfeiltasten springen um 1 s, mit Umschalt um 10 s</translation>
    </message>
    <message>
        <source>reads through the mission…</source>
        <translation>liest die Mission durch…</translation>
    </message>
</context>
<context>
    <name>leitstand::TimelineFeature</name>
    <message>
        <source>&amp;Previous mark</source>
        <translation>&amp;Vorige Marke</translation>
    </message>
    <message>
        <source>Back to the mark before</source>
        <translation>Zurück zur vorigen Marke</translation>
    </message>
    <message>
        <source>Play &amp;backwards</source>
        <translation>&amp;Rückwärts abspielen</translation>
    </message>
    <message>
        <source>Plays backwards, or stands</source>
        <translation>Spielt rückwärts ab oder steht</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Plays, or stands</source>
        <translation>Spielt ab oder steht</translation>
    </message>
    <message>
        <source>&amp;Next mark</source>
        <translation>&amp;Nächste Marke</translation>
    </message>
    <message>
        <source>On to the next mark</source>
        <translation>Weiter zur nächsten Marke</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>Plays slower, down to a tenth</source>
        <translation>Spielt langsamer ab, bis zu einem Zehntel</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>&amp;Schneller</translation>
    </message>
    <message>
        <source>Plays faster, up to 32 times</source>
        <translation>Spielt schneller ab, bis zum 32-Fachen</translation>
    </message>
    <message>
        <source>Next &amp;victim</source>
        <translation>Nächstes &amp;Opfer</translation>
    </message>
    <message>
        <source>Next &amp;alarm</source>
        <translation>Nächster Alar&amp;m</translation>
    </message>
    <message>
        <source>On to the next alarm, from the last to the first</source>
        <translation>Weiter zum nächsten Alarm, vom letzten zum ersten</translation>
    </message>
    <message>
        <source>Next n&amp;ote</source>
        <translation>Nächste No&amp;tiz</translation>
    </message>
    <message>
        <source>On to the next note, from the last to the first</source>
        <translation>Weiter zur nächsten Notiz, von der letzten zur ersten</translation>
    </message>
    <message>
        <source>&amp;Map as finished</source>
        <translation>&amp;Karte im Endstand</translation>
    </message>
    <message>
        <source>The map as the mission ended, with all corrections; else as it was then</source>
        <translation>Die Karte, wie die Mission endete, mit allen Korrekturen; sonst wie sie damals war</translation>
    </message>
    <message>
        <source>Plays at %1</source>
        <translation>Spielt mit %1</translation>
    </message>
    <message>
        <source>There is no such mark</source>
        <translation>Es gibt keine solche Marke</translation>
    </message>
    <message>
        <source>Previous v&amp;ictim</source>
        <translation>Voriges O&amp;pfer</translation>
    </message>
    <message>
        <source>Stop &amp;mapping</source>
        <translation>Kartierung &amp;beenden</translation>
    </message>
    <message>
        <source>No station made a map of this mission, so that its point clouds are registered first; stopped, the review has those that are registered by then</source>
        <translation>Keine Station hat eine Karte dieser Mission gemacht, deshalb werden zuerst ihre Punktwolken registriert; beendet, hat die Durchsicht die bis dahin registrierten</translation>
    </message>
    <message>
        <source>registers the point clouds, since no station made a map: %1 %</source>
        <translation>registriert die Punktwolken, da keine Station eine Karte gemacht hat: %1 %</translation>
    </message>
    <message>
        <source>On to where the next victim was filed or changed, from the last to the first</source>
        <translation>Weiter dorthin, wo das nächste Opfer erfasst oder geändert wurde, vom letzten zum ersten</translation>
    </message>
    <message>
        <source>Back to where the victim before was filed or changed, from the first to the last</source>
        <translation>Zurück dorthin, wo das vorige Opfer erfasst oder geändert wurde, vom ersten zum letzten</translation>
    </message>
    <message>
        <source>Next &amp;hazard</source>
        <translation>Nächstes &amp;Gefahrzeichen</translation>
    </message>
    <message>
        <source>On to the next hazard sign, QR code or object, from the last to the first</source>
        <translation>Weiter zum nächsten Gefahrzeichen, QR-Code oder Objekt, vom letzten zum ersten</translation>
    </message>
    <message>
        <source>Next &amp;candidate</source>
        <translation>Nächster &amp;Kandidat</translation>
    </message>
    <message>
        <source>On to what the station believed next to have found, from the last to the first</source>
        <translation>Weiter zu dem, was die Station als Nächstes gefunden zu haben glaubte, vom letzten zum ersten</translation>
    </message>
</context>
<context>
    <name>leitstand::TonePlayer</name>
    <message>
        <source>No sound device: alarms are seen, not heard.</source>
        <translation>Kein Tongerät: Alarme sind zu sehen, nicht zu hören.</translation>
    </message>
    <message>
        <source>The sound device does not work: alarms are seen, not heard.</source>
        <translation>Das Tongerät funktioniert nicht: Alarme sind zu sehen, nicht zu hören.</translation>
    </message>
</context>
<context>
    <name>leitstand::TopicRowsModel</name>
    <message>
        <source>Topic</source>
        <translation>Topic</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Nobody publishes it</source>
        <translation>Niemand veröffentlicht es</translation>
    </message>
</context>
<context>
    <name>leitstand::TopicWords</name>
    <message>
        <source>Nothing came yet</source>
        <translation>Noch nichts gekommen</translation>
    </message>
    <message>
        <source>%1 ms ago</source>
        <translation>vor %1 ms</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>vor %1 s</translation>
    </message>
    <message>
        <source>%1 Hz · %2 Mbit/s · %3</source>
        <translation>%1 Hz · %2 Mbit/s · %3</translation>
    </message>
</context>
<context>
    <name>leitstand::Topics</name>
    <message>
        <source>{} numbers: {} ...</source>
        <translation>{} Zahlen: {} ...</translation>
    </message>
    <message>
        <source> ({} to {})</source>
        <translation> ({} bis {})</translation>
    </message>
    <message>
        <source>{} elements</source>
        <translation>{} Elemente</translation>
    </message>
    <message>
        <source>The publisher is asked what {} is made of</source>
        <translation>Der Absender wird gefragt, woraus {} besteht</translation>
    </message>
    <message>
        <source>The text of {} is not known here, and its publisher does not tell it (ROS 2 Iron and later do): its fields cannot be shown</source>
        <translation>Der Text von {} ist hier nicht bekannt, und sein Absender nennt ihn nicht (ab ROS 2 Iron möglich): Seine Felder können nicht gezeigt werden</translation>
    </message>
    <message>
        <source>What its publisher tells of {} is not read: {}</source>
        <translation>Was sein Absender von {} sagt, ist nicht lesbar: {}</translation>
    </message>
    <message>
        <source>The text of {} is not known here, and {} does not answer what it is</source>
        <translation>Der Text von {} ist hier nicht bekannt, und {} antwortet nicht, was er ist</translation>
    </message>
</context>
<context>
    <name>leitstand::TopicsFeature</name>
    <message>
        <source>&amp;Topics of the network</source>
        <translation>&amp;Topics im Netz</translation>
    </message>
    <message>
        <source>Lists all topics, and shows what comes on one of them</source>
        <translation>Listet alle Topics auf und zeigt, was auf einem davon kommt</translation>
    </message>
    <message>
        <source> · not all of its fields</source>
        <translation> · nicht alle Felder</translation>
    </message>
</context>
<context>
    <name>leitstand::TopicsPanel</name>
    <message>
        <source>Topics</source>
        <translation>Topics</translation>
    </message>
    <message>
        <source>Words of topic, type or node</source>
        <translation>Wörter aus Topic, Typ oder Knoten</translation>
    </message>
    <message>
        <source>Topics of the domain</source>
        <translation>Topics der Domäne</translation>
    </message>
    <message>
        <source>The newest message of the chosen topic</source>
        <translation>Die neueste Nachricht des gewählten Topics</translation>
    </message>
    <message>
        <source>Choose a topic: what comes on it is shown here, and only then loads the link</source>
        <translation>Ein Topic wählen: hier steht dann, was darauf kommt; erst dann belastet es die Verbindung</translation>
    </message>
</context>
<context>
    <name>leitstand::TransportBar</name>
    <message>
        <source>Speed of the review</source>
        <translation>Tempo der Auswertung</translation>
    </message>
    <message>
        <source>Moment that is shown</source>
        <translation>Gezeigter Zeitpunkt</translation>
    </message>
    <message>
        <source>%1   %2 of %3</source>
        <translation>%1   %2 von %3</translation>
    </message>
</context>
<context>
    <name>leitstand::TrendPlot</name>
    <message>
        <source>Plot</source>
        <translation>Verlauf</translation>
    </message>
</context>
<context>
    <name>leitstand::Verdict</name>
    <message>
        <source>The iteration came to rest.</source>
        <translation>Die Iteration kam zur Ruhe.</translation>
    </message>
    <message>
        <source>The iteration ended swinging between two poses.</source>
        <translation>Die Iteration endete im Pendeln zwischen zwei Posen.</translation>
    </message>
    <message>
        <source>The limit of iterations was reached before the pose came to rest.</source>
        <translation>Die Grenze der Iterationen wurde erreicht, bevor die Pose zur Ruhe kam.</translation>
    </message>
    <message>
        <source>Too few pairs of points: the scan stands where it was expected. A larger maximum distance may help.</source>
        <translation>Zu wenige Punktpaare: der Scan steht, wo er erwartet wurde. Ein größerer maximaler Abstand hilft vielleicht.</translation>
    </message>
    <message>
        <source>The registration was cancelled.</source>
        <translation>Die Registrierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>uncertain</source>
        <translation>unsicher</translation>
    </message>
    <message>
        <source>not converged</source>
        <translation>nicht konvergiert</translation>
    </message>
    <message>
        <source>The first scan defines the map&apos;s frame; the others are registered to it.</source>
        <translation>Der erste Scan bestimmt das Koordinatensystem der Karte; die anderen werden darauf registriert.</translation>
    </message>
    <message>
        <source>Some direction is hardly held, as along a bare corridor: certainty %1, below %2.</source>
        <translation>Eine Richtung ist kaum gehalten, wie in einem kahlen Gang: Gewissheit %1, unter %2.</translation>
    </message>
    <message>
        <source>Every direction is held: certainty %1 (uncertain below %2).</source>
        <translation>Jede Richtung ist gehalten: Gewissheit %1 (unsicher unter %2).</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimChoices</name>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>surface: lies open</source>
        <translation>Oberfläche: liegt frei</translation>
    </message>
    <message>
        <source>trapped: partly covered</source>
        <translation>eingeklemmt: teils verdeckt</translation>
    </message>
    <message>
        <source>void: in a hollow</source>
        <translation>Hohlraum: liegt darin</translation>
    </message>
    <message>
        <source>entombed: covered</source>
        <translation>verschüttet: verdeckt</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>gelb</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>orange</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rot</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Gestalt</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Geräusch</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>ppm</source>
        <translation>ppm</translation>
    </message>
    <message>
        <source>absent</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>present</source>
        <translation>vorhanden</translation>
    </message>
    <message>
        <source>whole body</source>
        <translation>ganzer Körper</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>waving</source>
        <translation>winkt</translation>
    </message>
    <message>
        <source>breathing</source>
        <translation>atmet</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Gesicht</translation>
    </message>
    <message>
        <source>calling</source>
        <translation>ruft</translation>
    </message>
    <message>
        <source>tapping</source>
        <translation>klopft</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>steigend</translation>
    </message>
    <message>
        <source>steady</source>
        <translation>gleichbleibend</translation>
    </message>
    <message>
        <source>%1 …</source>
        <comment>what one may write: waving, breathing …</comment>
        <translation>%1 …</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between words</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>beside a wall</source>
        <translation>an einer Wand</translation>
    </message>
    <message>
        <source>in a corner</source>
        <translation>in einer Ecke</translation>
    </message>
    <message>
        <source>behind a door</source>
        <translation>hinter einer Tür</translation>
    </message>
    <message>
        <source>under a table</source>
        <translation>unter einem Tisch</translation>
    </message>
    <message>
        <source>in a box</source>
        <translation>in einer Kiste</translation>
    </message>
    <message>
        <source>the way is narrow</source>
        <translation>der Weg ist eng</translation>
    </message>
    <message>
        <source>the way is steep</source>
        <translation>der Weg ist steil</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimForm</name>
    <message>
        <source>Situation</source>
        <translation>Situation</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Schild</translation>
    </message>
    <message>
        <source>what is written on it</source>
        <translation>was darauf steht</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>how to get there, what to mind</source>
        <translation>Weg dorthin, worauf zu achten ist</translation>
    </message>
    <message>
        <source>Form of the chosen find</source>
        <translation>Formular des gewählten Fundes</translation>
    </message>
    <message>
        <source>%1, in words</source>
        <translation>%1, in Worten</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1, gemessen</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Choose a find to fill in its form</source>
        <translation>Einen Fund wählen, um sein Formular auszufüllen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Where the find is; unknown: in the area of the mission</source>
        <translation>Wo der Fund ist; unbekannt: im Bereich der Mission</translation>
    </message>
    <message>
        <source>How the victim lies there</source>
        <translation>Wie das Opfer dort liegt</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Closes the form; what was filled in is kept already</source>
        <translation>Schließt das Formular; was eingetragen wurde, ist schon gesichert</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimListModel</name>
    <message>
        <source>%1, %2</source>
        <comment>hazard, confirmed</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Fund</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Signs</source>
        <translation>Zeichen</translation>
    </message>
    <message>
        <source>Found</source>
        <comment>when</comment>
        <translation>Gefunden</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimRows</name>
    <message>
        <source>no %1</source>
        <comment>a sign of life</comment>
        <translation>ohne %1</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>heat %1 °C</source>
        <translation>Wärme %1 °C</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>CO₂ %1 ppm</source>
        <translation>CO₂ %1 ppm</translation>
    </message>
    <message>
        <source>the robot&apos;s own</source>
        <translation>vom Roboter selbst</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>bestätigt</translation>
    </message>
    <message>
        <source>unconfirmed</source>
        <translation>unbestätigt</translation>
    </message>
    <message>
        <source>candidate %1</source>
        <translation>Kandidat %1</translation>
    </message>
    <message>
        <source>victim</source>
        <translation>Opfer</translation>
    </message>
    <message>
        <source>hazard</source>
        <translation>Gefahr</translation>
    </message>
    <message>
        <source>QR code</source>
        <translation>QR-Code</translation>
    </message>
    <message>
        <source>object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1, ahead</source>
        <translation>%1, vorn</translation>
    </message>
    <message>
        <source>%1, behind</source>
        <translation>%1, hinten</translation>
    </message>
    <message>
        <source>%1, %2° left</source>
        <translation>%1, %2° links</translation>
    </message>
    <message>
        <source>%1, %2° right</source>
        <translation>%1, %2° rechts</translation>
    </message>
    <message>
        <source>form</source>
        <translation>Gestalt</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>Geräusch</translation>
    </message>
    <message>
        <source> ppm</source>
        <translation> ppm</translation>
    </message>
    <message>
        <source>1 victim</source>
        <translation>1 Opfer</translation>
    </message>
    <message>
        <source>%1 victims</source>
        <translation>%1 Opfer</translation>
    </message>
    <message>
        <source>, %1 not confirmed</source>
        <translation>, %1 unbestätigt</translation>
    </message>
    <message>
        <source> · %1 others</source>
        <translation> · %1 andere</translation>
    </message>
    <message>
        <source> · %1 candidates</source>
        <translation> · %1 Kandidaten</translation>
    </message>
    <message>
        <source> · %1 discarded</source>
        <translation> · %1 verworfen</translation>
    </message>
    <message>
        <source>tag %1</source>
        <translation>Schild %1</translation>
    </message>
    <message>
        <source> · 1 other</source>
        <translation> · 1 weiterer</translation>
    </message>
    <message>
        <source> · 1 candidate</source>
        <translation> · 1 Kandidat</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimsFeature</name>
    <message>
        <source>&amp;Victim here</source>
        <translation>&amp;Opfer hier</translation>
    </message>
    <message>
        <source>F Victim</source>
        <translation>F Opfer</translation>
    </message>
    <message>
        <source>Keeps what the robot sees as a victim: the sharpest pictures, heat, gas, scan and place</source>
        <translation>Sichert, was der Roboter sieht, als Opfer: die schärfsten Bilder, Wärme, Gas, Scan und Ort</translation>
    </message>
    <message>
        <source>Con&amp;firm the find</source>
        <translation>Fund &amp;bestätigen</translation>
    </message>
    <message>
        <source>V Confirm</source>
        <translation>V Bestätigen</translation>
    </message>
    <message>
        <source>Confirms the chosen find, or the one that was filed last; files a chosen candidate</source>
        <translation>Bestätigt den gewählten Fund oder den zuletzt erfassten; erfasst einen gewählten Kandidaten</translation>
    </message>
    <message>
        <source>Ha&amp;zard here</source>
        <translation>&amp;Gefahr hier</translation>
    </message>
    <message>
        <source>Hazard</source>
        <translation>Gefahr</translation>
    </message>
    <message>
        <source>The same for a hazard sign</source>
        <translation>Dasselbe für ein Gefahrzeichen</translation>
    </message>
    <message>
        <source>&amp;QR code here</source>
        <translation>&amp;QR-Code hier</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>The same for a QR code</source>
        <translation>Dasselbe für einen QR-Code</translation>
    </message>
    <message>
        <source>&amp;Object here</source>
        <translation>Ob&amp;jekt hier</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>The same for an object of interest</source>
        <translation>Dasselbe für ein Objekt von Interesse</translation>
    </message>
    <message>
        <source>&amp;Discard the find</source>
        <translation>Fund &amp;verwerfen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Merge with the nearest</source>
        <translation>Mit dem nächsten v&amp;ereinen</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Vereinen</translation>
    </message>
    <message>
        <source>The chosen find is the same as the nearest one of its kind, which gets its evidence</source>
        <translation>Der gewählte Fund ist derselbe wie der nächste seiner Art, der seine Belege erhält</translation>
    </message>
    <message>
        <source>Undo the last &amp;entry on finds</source>
        <translation>Letzten Eintrag zu Funden &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Takes back what was filed, changed, confirmed or discarded last</source>
        <translation>Nimmt zurück, was zuletzt erfasst, geändert, bestätigt oder verworfen wurde</translation>
    </message>
    <message>
        <source>Mo&amp;ve the find on the map</source>
        <translation>Fund auf der Karte ver&amp;schieben</translation>
    </message>
    <message>
        <source>Click on the map where the chosen find is; without one a new victim is filed there</source>
        <translation>Auf der Karte anklicken, wo der gewählte Fund ist; ohne Fund wird dort ein neues Opfer erfasst</translation>
    </message>
    <message>
        <source>Form: &amp;next field</source>
        <translation>Formular: &amp;nächstes Feld</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Of the chosen find&apos;s form</source>
        <translation>Im Formular des gewählten Fundes</translation>
    </message>
    <message>
        <source>Form: &amp;previous field</source>
        <translation>Formular: vor&amp;iges Feld</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Voriges</translation>
    </message>
    <message>
        <source>Form: next &amp;choice</source>
        <translation>Formular: nächste &amp;Wahl</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Unknown, absent, present; situations; areas</source>
        <translation>Unbekannt, fehlt, vorhanden; Situationen; Bereiche</translation>
    </message>
    <message>
        <source>Click where %1 is · right button: not at all</source>
        <translation>Anklicken, wo %1 ist · rechte Taste: abbrechen</translation>
    </message>
    <message>
        <source>Click where the victim is · right button: not at all</source>
        <translation>Anklicken, wo das Opfer ist · rechte Taste: abbrechen</translation>
    </message>
    <message>
        <source>Choose the find that is none</source>
        <translation>Erst den Fund wählen, der keiner ist</translation>
    </message>
    <message>
        <source>Choose the find that is part of another one</source>
        <translation>Erst den Fund wählen, der Teil eines anderen ist</translation>
    </message>
    <message>
        <source>Takes the chosen find or candidate, or the newest find, off the list; undo brings it back</source>
        <translation>Nimmt den gewählten Fund oder Kandidaten oder den neuesten Fund von der Liste; Rückgängig bringt ihn wieder</translation>
    </message>
    <message>
        <source>Choose a filed find, to fill in its form</source>
        <translation>Einen angelegten Fund wählen, um sein Formular auszufüllen</translation>
    </message>
    <message>
        <source>Nothing to choose from here: what was typed stays</source>
        <translation>Hier gibt es nichts auszuwählen: Getipptes bleibt</translation>
    </message>
</context>
<context>
    <name>leitstand::VictimsPanel</name>
    <message>
        <source>Nothing found yet. F files what the robot sees.</source>
        <translation>Noch nichts gefunden. F erfasst, was der Roboter sieht.</translation>
    </message>
    <message>
        <source>Victims and other finds</source>
        <translation>Opfer und andere Funde</translation>
    </message>
    <message>
        <source>Victims, other finds and candidates</source>
        <translation>Opfer, andere Funde und Kandidaten</translation>
    </message>
    <message>
        <source>Nothing was found yet</source>
        <translation>Noch nichts gefunden</translation>
    </message>
    <message>
        <source>Finds; Return goes to the moment when the chosen one was found</source>
        <translation>Funde; Eingabe geht zu dem Augenblick, in dem der gewählte gefunden wurde</translation>
    </message>
</context>
<context>
    <name>leitstand::ViewCommands</name>
    <message>
        <source>&amp;Points</source>
        <translation>&amp;Punkte</translation>
    </message>
    <message>
        <source>Shows the scans&apos; points</source>
        <translation>Zeigt die Punkte der Scans</translation>
    </message>
    <message>
        <source>&amp;Voxels</source>
        <translation>&amp;Voxel</translation>
    </message>
    <message>
        <source>Shows the map as cubes</source>
        <translation>Zeigt die Karte als Würfel</translation>
    </message>
    <message>
        <source>&amp;Floor plan</source>
        <translation>&amp;Grundriss</translation>
    </message>
    <message>
        <source>Shows the map from above with a 1 m grid</source>
        <translation>Zeigt die Karte von oben mit einem Raster von 1 m</translation>
    </message>
    <message>
        <source>Colour by &amp;label</source>
        <translation>Farbe nach &amp;Label</translation>
    </message>
    <message>
        <source>Floor blue, wall yellow, ceiling red</source>
        <translation>Boden blau, Wand gelb, Decke rot</translation>
    </message>
    <message>
        <source>Colour by &amp;scan</source>
        <translation>Farbe nach &amp;Scan</translation>
    </message>
    <message>
        <source>A colour for each scan: shows how well they fit</source>
        <translation>Eine Farbe je Scan: zeigt, wie gut sie passen</translation>
    </message>
    <message>
        <source>Colour by &amp;height</source>
        <translation>Farbe nach &amp;Höhe</translation>
    </message>
    <message>
        <source>Colour by &amp;range</source>
        <translation>Farbe nach &amp;Entfernung</translation>
    </message>
    <message>
        <source>Distance from the scanner</source>
        <translation>Entfernung vom Scanner</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>&amp;Dunkles Design</translation>
    </message>
    <message>
        <source>L&amp;ight theme</source>
        <translation>Helles Des&amp;ign</translation>
    </message>
    <message>
        <source>For sunlit places</source>
        <translation>Für sonnige Orte</translation>
    </message>
    <message>
        <source>R&amp;eset camera</source>
        <translation>Kamera zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Shows the whole map</source>
        <translation>Zeigt die ganze Karte</translation>
    </message>
    <message>
        <source>Camera from &amp;above</source>
        <translation>Kamera von &amp;oben</translation>
    </message>
    <message>
        <source>Camera from the s&amp;ide</source>
        <translation>Kamera von der Sei&amp;te</translation>
    </message>
    <message>
        <source>&amp;Before registration</source>
        <translation>Vor der Registrieru&amp;ng</translation>
    </message>
    <message>
        <source>Shows the scans where they were expected before registration</source>
        <translation>Zeigt die Scans, wo sie vor der Registrierung erwartet wurden</translation>
    </message>
    <message>
        <source>Clip by hei&amp;ght</source>
        <translation>Nach Höhe &amp;kappen</translation>
    </message>
    <message>
        <source>Shows only a slice of the map, between two heights</source>
        <translation>Zeigt nur eine Schicht der Karte, zwischen zwei Höhen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Click two points for their distance; Esc ends it</source>
        <translation>Zwei Punkte anklicken, um ihren Abstand zu messen; Esc beendet es</translation>
    </message>
    <message>
        <source>Click two points for their distance; the same key again ends it</source>
        <translation>Zwei Punkte anklicken für ihren Abstand; dieselbe Taste beendet es wieder</translation>
    </message>
    <message>
        <source>Colour by r&amp;obot</source>
        <translation>Farbe nach R&amp;oboter</translation>
    </message>
    <message>
        <source>Which robot&apos;s scanner saw it</source>
        <translation>Wessen Scanner es sah</translation>
    </message>
    <message>
        <source>Colour by &amp;intensity</source>
        <translation>Farbe nach &amp;Intensität</translation>
    </message>
    <message>
        <source>How strongly surfaces throw the laser back</source>
        <translation>Wie stark Flächen den Laser zurückwerfen</translation>
    </message>
    <message>
        <source>Colour by a&amp;ge</source>
        <translation>Farbe nach Al&amp;ter</translation>
    </message>
    <message>
        <source>When it came into the map: what is bright is new</source>
        <translation>Wann es in die Karte kam: was hell ist, ist neu</translation>
    </message>
</context>
<context>
    <name>leitstand::VirtualScanPane</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Virtual scan</source>
        <translation>Virtueller Scan</translation>
    </message>
    <message>
        <source>nearest obstacle %1 m</source>
        <translation>nächstes Hindernis %1 m</translation>
    </message>
    <message>
        <source>What is around the robot, its front up.
Yellow: walls. Dots: obstacles, fainter the longer ago they were seen.
Dashed: where it goes. The wheel, + and − zoom; a double click resets.</source>
        <translation>Was um den Roboter ist, vorn ist oben.
Gelb: Wände. Punkte: Hindernisse, blasser, je länger sie zurückliegen.
Gestrichelt: wohin er fährt. Rad, + und − zoomen; ein Doppelklick setzt zurück.</translation>
    </message>
</context>
<context>
    <name>leitstand::WireWords</name>
    <message>
        <source>robot offers {0}, we asked for {1}</source>
        <translation>Roboter bietet {0}, wir verlangen {1}</translation>
    </message>
    <message>
        <source>we offer {1}, robot asks for {0}</source>
        <translation>wir bieten {1}, Roboter verlangt {0}</translation>
    </message>
    <message>
        <source>robot sends {0}, we expected {1}</source>
        <translation>Roboter sendet {0}, wir erwarten {1}</translation>
    </message>
    <message>
        <source>robot expects {0}, we send {1}</source>
        <translation>Roboter erwartet {0}, wir senden {1}</translation>
    </message>
    <message>
        <source>robot&apos;s topic has keys, ours has none as in ROS 2</source>
        <translation>das Topic des Roboters hat Schlüssel, unseres wie in ROS 2 keine</translation>
    </message>
    <message>
        <source>robot offers exclusive ownership, we share as ROS 2 does</source>
        <translation>Roboter bietet exklusive Ownership, wir teilen wie ROS 2</translation>
    </message>
    <message>
        <source>robot asks for exclusive ownership, we share as ROS 2 does</source>
        <translation>Roboter verlangt exklusive Ownership, wir teilen wie ROS 2</translation>
    </message>
    <message>
        <source>robot is in partition &quot;{0}&quot;, we are in the default one</source>
        <translation>Roboter ist in Partition „{0}“, wir sind in der voreingestellten</translation>
    </message>
    <message>
        <source>robot writes XCDR2 only, we read XCDR1</source>
        <translation>Roboter schreibt nur XCDR2, wir lesen XCDR1</translation>
    </message>
    <message>
        <source>robot reads XCDR2 only, we write XCDR1</source>
        <translation>Roboter liest nur XCDR2, wir schreiben XCDR1</translation>
    </message>
    <message>
        <source>robot asks for a liveliness that we do not offer</source>
        <translation>Roboter verlangt eine Liveliness, die wir nicht bieten</translation>
    </message>
    <message>
        <source>security: permissions or governance of one side do not let them talk</source>
        <translation>Sicherheit: Permissions oder Governance einer Seite erlauben den Austausch nicht</translation>
    </message>
</context>
</TS>
