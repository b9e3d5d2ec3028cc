/** German texts of the fields of machines, boards, tools and cartons, by their English texts. */

export const schemaTexts: Readonly<Record<string, string>> = {
  X: "X",
  Y: "Y",
  Z: "Z",
  C: "C",
  "heading of the tool head (degrees); without it, the machine turns no tool":
    "Richtung des Werkzeugkopfs (Grad); ohne diese Achse dreht die Maschine kein Werkzeug",
  Low: "Niedrig",
  "least joint position": "Kleinste Position der Achse",
  High: "Hoch",
  "greatest joint position": "Größte Position der Achse",
  Velocity: "Geschwindigkeit",
  "greatest velocity, per second": "Größte Geschwindigkeit, je Sekunde",
  Acceleration: "Beschleunigung",
  "greatest acceleration, per second squared": "Größte Beschleunigung, je Sekunde im Quadrat",
  "Parking position": "Parkposition",
  "position of y while another carriage is in use, at the carriage's own end of the gantry (mm)":
    "Position von y, während ein anderer Schlitten arbeitet, am eigenen Ende des Portals (mm)",
  "without it, the carriage shares the Z of the first carriage":
    "Ohne diese Achse hat der Schlitten die Z-Achse des ersten Schlittens",
  "heading of the tools of the carriage (degrees)": "Richtung der Werkzeuge des Schlittens (Grad)",
  Kind: "Art",
  Radius: "Radius",
  "R, radius of the wheel (mm)": "R, Radius des Rads (mm)",
  Width: "Breite",
  "width of the rim (mm)": "Breite der Lauffläche (mm)",
  "Feed rate": "Vorschub",
  Plunge: "Eintauchen",
  "r, radius of the cutter (mm)": "r, Radius des Fräsers (mm)",
  Speed: "Geschwindigkeit",
  "speed of the spindle (rpm)": "Drehzahl der Spindel (1/min)",
  "Spin up": "Hochlaufzeit",
  "time until the spindle has its full speed (s)":
    "Zeit, bis die Spindel die volle Drehzahl hat (s)",
  Lead: "Vorlauf",
  "length of the straight lead-in (mm); 0: 1.5 r": "Länge der geraden Anfahrt (mm); 0: 1,5 r",
  Approach: "Anfahren",
  "angle of the lead-in to the contour (degrees); 0: in line":
    "Winkel der Anfahrt zur Kontur (Grad); 0: in ihrer Richtung",
  Step: "Schritt",
  "maximum depth of one pass (mm); 0: one pass":
    "Größte Tiefe eines Durchgangs (mm); 0: ein Durchgang",
  Dwell: "Verweilzeit",
  "maximum time at a corner before the board burns (s); 0: no limit":
    "Längste Zeit an einer Ecke, bevor das Material verbrennt (s); 0: keine Grenze",
  mm: "mm",
  "mounting angle (degrees)": "Einbauwinkel (Grad)",
  "Least distance of carriages": "Kleinster Abstand der Schlitten",
  "least distance along Y between the positions of two carriages (mm)":
    "Kleinster Abstand der Positionen zweier Schlitten in Y (mm)",
  "position of y of the first carriage while another is in use (mm)":
    "Position von y des ersten Schlittens, während ein anderer arbeitet (mm)",
  Carriage: "Schlitten",
  "second and further carriages, in the order of their numbers":
    "Zweiter und weitere Schlitten, in der Reihenfolge ihrer Nummern",
  Letter: "Buchstabe",
  "letter of the axis in programs": "Buchstabe der Achse in Programmen",
  "Blade angle": "Klingenwinkel",
  "slant of the leading edge from the vertical (degrees)":
    "Neigung der vorderen Schneide gegen die Senkrechte (Grad)",
  "Blade width": "Klingenbreite",
  "width of the blade along the cut (mm)": "Breite der Klinge entlang des Schnitts (mm)",
  Swivel: "Drehen",
  "swivel angle: at corners sharper than this the knife is turned above the board, a free one at its swivel depth (degrees)":
    "An spitzeren Ecken wird das Messer über dem Material gedreht, ein freies in seiner Schwenktiefe (Grad)",
  Oscillating: "Oszillierend",
  Trail: "Nachlauf",
  "e, distance of the tip behind the head's axis (mm)":
    "e, Abstand der Spitze hinter der Kopfachse (mm)",
  "Lead in": "Anlauf",
  "length of the arc from the waste to an outer contour (mm)":
    "Länge des Bogens vom Abfall zu einer Außenkontur (mm)",
  "Lead out": "Auslauf",
  "length of the arc from an outer contour to the waste (mm)":
    "Länge des Bogens von einer Außenkontur in den Abfall (mm)",
  "Least radius": "Kleinster Radius",
  "smallest radius that the blade turns in (mm); 0: no limit":
    "Kleinster Radius, den die Klinge schneidet (mm); 0: keine Grenze",
  Free: "Frei",
  "the blade trails its axis freely; no axis of the machine turns it":
    "Die Klinge läuft ihrer Achse frei nach; keine Achse der Maschine dreht sie",
  "Swivel depth": "Drehtiefe",
  "depth of the tip in the board while a free blade is turned about it (mm); 0: the full depth":
    "Tiefe der Spitze im Material, während eine freie Klinge um sie gedreht wird (mm); 0: die volle Tiefe",
  "Park heading": "Parkrichtung",
  "heading of a free blade at the start and at the end of each program (degrees)":
    "Richtung einer freien Klinge am Anfang und am Ende jedes Programms (Grad)",
  "Slow radius": "Radius für Langsamfahrt",
  "radius of a curve below which the feed is lower in proportion to the radius (mm); 0: nowhere":
    "Kurvenradius, unter dem der Vorschub im Verhältnis zum Radius kleiner ist (mm); 0: nirgends",
  Kerf: "Schnittspalt",
  "width of the cut (mm); half of it is the radius r":
    "Breite des Schnitts (mm); die Hälfte ist der Radius r",
  Power: "Leistung",
  "S word of full power, in units of the controller ($30)":
    "S-Wort der vollen Leistung, in Einheiten der Steuerung ($30)",
  Pierce: "Einstechen",
  "dwell at the start of a cut until the board is pierced (s)":
    "Wartezeit am Anfang eines Schnitts, bis das Material durchstochen ist (s)",
  Focus: "Fokus",
  "height of the focus above the board's top face (mm)":
    "Höhe des Fokus über der Oberseite des Materials (mm)",
  "length of the lead-in from the pierced hole (mm); 0: 1.5 r":
    "Länge der Anfahrt vom Einstichloch (mm); 0: 1,5 r",
  Air: "Luft",
  "digital output of the air assist; -1 for none": "Digitaler Ausgang der Blasluft; -1: keiner",
  "letter of the axis in programs; X, Y, Z and the letter of c belong to [axes]":
    "Buchstabe der Achse in Programmen; X, Y, Z und der Buchstabe von c gehören zu [axes]",
  Number: "Nummer",
  "tool number in programs (T word)": "Werkzeugnummer in Programmen (T-Wort)",
  Name: "Name",
  "Offset of the station": "Versatz der Station",
  Output: "Ausgang",
  "digital output that lowers the station or switches its tool on; -1 for none":
    "Digitaler Ausgang, der die Station senkt oder ihr Werkzeug einschaltet; -1: keiner",
  "number of the carriage that carries the station; 1 is the first":
    "Nummer des Schlittens, der die Station trägt; 1 ist der erste",
  "Radius of the holder": "Radius des Halters",
  "radius about the axis of the station of its holder at the height of the tip, for keep-out zones (mm); 0: the tool only":
    "Radius des Halters um die Achse der Station auf Höhe der Spitze, für Sperrzonen (mm); 0: nur das Werkzeug",
  "Tool life": "Standzeit des Werkzeugs",
  "length that the tool may work in the board before it is changed (m); 0: no limit":
    "Länge, die das Werkzeug im Material arbeitet, bevor es gewechselt wird (m); 0: keine Grenze",
  Spindle: "Spindel",
  "word that switches the oscillation or the spindle of the tool on: M3 turns clockwise, M4 counter-clockwise":
    "Wort, das die Oszillation oder die Spindel des Werkzeugs einschaltet: M3 dreht im Uhrzeigersinn, M4 dagegen",
  "Spindle speed": "Spindeldrehzahl",
  "S word with it, if the controller needs another than the speed of the tool; 0: the speed of a cutter, the power of a laser, and 1 for an oscillating knife":
    "S-Wort dazu, wenn die Steuerung ein anderes als die Drehzahl des Werkzeugs braucht; 0: die Drehzahl eines Fräsers, die Leistung eines Lasers, 1 bei einem oszillierenden Messer",
  Tool: "Werkzeug",
  Back: "Rücken",
  "d, distance of tip and head axis across the cutting edge (mm)":
    "d, Abstand von Spitze und Kopfachse quer zur Schneide (mm)",
  "Half width": "Halbe Breite",
  "r, distance of tip and head axis along the cutting edge (mm)":
    "r, Abstand von Spitze und Kopfachse entlang der Schneide (mm)",
  Tilt: "Neigung",
  "θ, angle of the blade from the vertical (degrees)":
    "θ, Winkel der Klinge gegen die Senkrechte (Grad)",
  "name for messages": "Name für Meldungen",
  "position of the left edge (mm)": "Position der linken Kante (mm)",
  "position of the lower edge (mm)": "Position der unteren Kante (mm)",
  "size along X (mm)": "Größe in X (mm)",
  Height: "Höhe",
  "size along Y (mm)": "Größe in Y (mm)",
  Top: "Oben",
  "height of the top of the zone above the mat (mm)": "Höhe der Oberseite über der Matte (mm)",
  Title: "Titel",
  "name of the device": "Name des Geräts",
  Units: "Einheiten",
  "plotter units in one millimetre": "Plottereinheiten je Millimeter",
  "Reachable area": "Erreichbarer Bereich",
  "x and y of two corners of the reachable area: x0, y0, x1, y1 (units)":
    "x und y zweier Ecken des erreichbaren Bereichs: x0, y0, x1, y1 (Einheiten)",
  Left: "Links",
  Bottom: "Unten",
  Right: "Rechts",
  Origin: "Nullpunkt",
  "place of unit 0, 0: lower left corner or centre of the table":
    "Lage der Einheit 0, 0: linke untere Ecke oder Mitte des Tischs",
  Pens: "Stifte",
  "number of tools that SP can select": "Zahl der Werkzeuge, die SP wählen kann",
  "least and greatest VS (cm/s), if the device has it":
    "Kleinste und größte VS (cm/s), falls das Gerät sie hat",
  "Least speed": "Kleinste Drehzahl",
  "Greatest speed": "Größte Drehzahl",
  Force: "Kraft",
  "least and greatest FS (steps of the device), if the device has it":
    "Kleinste und größte FS (Stufen des Geräts), falls das Gerät sie hat",
  "Least force": "Kleinste Kraft",
  "Greatest force": "Größte Kraft",
  Comments: "Kommentare",
  "the device reads the instruction CO (HP-GL/2)": "Das Gerät liest die Anweisung CO (HP-GL/2)",
  "number of the pen in programs (SP)": "Nummer des Stifts in Programmen (SP)",
  Station: "Station",
  "number of the station that holds the tool": "Nummer der Station, die das Werkzeug hält",
  Work: "Arbeit",
  "what the pen makes in the board": "Was der Stift im Material macht",
  "force (FS); 0 if the device has none": "Kraft (FS); 0, wenn das Gerät keine hat",
  "Name of the machine for display": "Name der Maschine für die Anzeige",
  "Machine and table": "Maschine und Tisch",
  "Width of the table, along X (mm)": "Breite des Tischs in X (mm)",
  "Height of the table, along Y (mm)": "Höhe des Tischs in Y (mm)",
  "Controller language": "Steuerungssprache",
  "Name of the controller language in machine files":
    "Name der Steuerungssprache in Maschinendateien",
  "Loading of sheets": "Zufuhr der Bogen",
  "How sheets reach the table. manual: every job and every copy waits until the operator confirms that the sheet is on the table. automatic: the machine starts without confirmation":
    "Wie Bogen auf den Tisch kommen. manuell: Jeder Auftrag und jede Kopie wartet, bis der Bediener bestätigt, dass der Bogen liegt. automatisch: Die Maschine startet ohne Bestätigung",
  "Thickest board": "Dickstes Material",
  "Greatest thickness of a board that the machine takes (mm); 0: no limit":
    "Größte Dicke eines Materials, das die Maschine aufnimmt (mm); 0: keine Grenze",
  "Angle between X and Y": "Winkel zwischen X und Y",
  "Angle γ from the axis X to the axis Y as the machine is built (degrees); below 90, Y leans to the right. Programs correct it: x = X + Y cos γ and y = Y sin γ on the sheet, if the axes are at X and Y without offsets":
    "Winkel γ von der Achse X zur Achse Y, wie die Maschine gebaut ist (Grad); unter 90 neigt sich Y nach rechts. Programme korrigieren ihn: x = X + Y cos γ und y = Y sin γ auf dem Bogen, wenn die Achsen ohne Versätze bei X und Y stehen",
  "Memory for programs": "Speicher für Programme",
  "Greatest size of a program that the controller takes (bytes), for one that stores the whole program before it begins; 0: no limit":
    "Größte Länge eines Programms, das die Steuerung nimmt (Byte), wenn sie das ganze Programm vor dem Beginn speichert; 0: keine Grenze",
  "Preparation of the machine": "Vorbereitung der Maschine",
  "What the operator does at the machine before each start, such as opening the vacuum zones; it is one of the checks before the start. Empty for none":
    "Was der Bediener vor jedem Start an der Maschine tut, etwa die Vakuumzonen öffnen; es ist eine der Prüfungen vor dem Start. Leer für nichts",
  "Travel height": "Fahrhöhe",
  "Height of the tip above the mat in air moves (mm)":
    "Höhe der Spitze über der Matte bei Leerfahrten (mm)",
  "Heights and waiting times": "Höhen und Wartezeiten",
  Clearance: "Sicherheitsabstand",
  "Height of the tip above the board where plunging begins (mm)":
    "Höhe der Spitze über dem Material, in der das Eintauchen beginnt (mm)",
  "Clearance in turns": "Freiraum beim Drehen",
  "Least distance of a tool from the board in turns, for jobs with the least lift (mm); 0: such jobs are refused":
    "Kleinster Abstand eines Werkzeugs vom Material beim Drehen, für Aufträge mit kleinstem Hub (mm); 0: solche Aufträge werden abgelehnt",
  "Depth in the mat": "Tiefe in der Matte",
  "Depth of a through cut in the mat (mm)": "Tiefe eines Durchschnitts in der Matte (mm)",
  "Creasing base": "Rillunterlage",
  "Surface on which the wheels press. rigid: the cutting mat, which counts as rigid. soft: a mat of felt or rubber, which yields":
    "Fläche, auf die die Räder drücken. starr: die Schneidmatte, die als starr gilt. weich: eine Matte aus Filz oder Gummi, die nachgibt",
  "Yield of a soft base": "Nachgiebigkeit einer weichen Unterlage",
  "Depth by which a soft creasing base yields under a wheel (mm); a rigid base does not yield":
    "Tiefe, um die eine weiche Rillunterlage unter einem Rad nachgibt (mm); eine starre gibt nicht nach",
  "creasing base for which the depths of creases are given; only on a soft one may they exceed the thickness; empty: any":
    "Rillunterlage, für die die Rilltiefen angegeben sind; nur auf einer weichen dürfen sie die Dicke überschreiten; leer: jede",
  "Waiting time of outputs": "Wartezeit der Ausgänge",
  "Waiting time after an output is switched (s)": "Wartezeit nach dem Schalten eines Ausgangs (s)",
  "Number of outputs": "Zahl der Ausgänge",
  "Number of digital outputs of the controller, for example num_dio of LinuxCNC's motmod; 0: not stated (LinuxCNC: 4)":
    "Zahl der digitalen Ausgänge der Steuerung, zum Beispiel num_dio von motmod bei LinuxCNC; 0: nicht angegeben (LinuxCNC: 4)",
  "Stations, tools and outputs": "Stationen, Werkzeuge und Ausgänge",
  "Place of the drawing": "Lage der Zeichnung",
  "Default position of the lower left corner of a drawing (mm)":
    "Übliche Lage der linken unteren Ecke einer Zeichnung (mm)",
  "Place in X": "Lage in X",
  "Place in Y": "Lage in Y",
  Axes: "Achsen",
  "Axes and travel": "Achsen und Verfahrwege",
  "Gantry with several carriages": "Portal mit mehreren Schlitten",
  "Carriages, if the machine has more than one": "Schlitten, wenn die Maschine mehr als einen hat",
  Zone: "Zone",
  "Keep-out zones on the table": "Sperrzonen auf dem Tisch",
  "Keep-out zones": "Sperrzonen",
  Arcs: "Kreisbögen",
  "Whether programs may contain arcs (G2, G3). chords: the controller has none, or does not turn the tool in them":
    "Ob Programme Bögen enthalten dürfen (G2, G3). Sehnen: Die Steuerung kennt keine oder dreht das Werkzeug darin nicht",
  Controller: "Steuerung",
  "Feed override": "Vorschubanpassung",
  "Least and greatest feed override while a program runs (%), of a controller that has one; programs begin with 100":
    "Kleinster und größter Vorschub-Override während eines Programms (%), falls die Steuerung einen hat; Programme beginnen mit 100",
  "Least feed override": "Kleinster Vorschub-Override",
  "Greatest feed override": "Größter Vorschub-Override",
  "Settings of the controller's language": "Einstellungen der Steuerungssprache",
  Device: "Gerät",
  "plotter or flat cutter: the name of a known device, or its properties":
    "Plotter oder Flachbettschneider: Name eines bekannten Geräts oder seine Eigenschaften",
  "flat-cutter": "flat-cutter",
  "flat-cutter-centred": "flat-cutter-centred",
  "hp-7475a-a3": "hp-7475a-a3",
  "Another, with these properties": "Ein anderes, mit diesen Eigenschaften",
  Pen: "Stift",
  "pens, one for each work of a tool": "Stifte, einer für jede Arbeit eines Werkzeugs",
  Pulses: "Impulse",
  Multiple: "Vielfaches",
  Start: "Start",
  Refill: "Nachfüllen",
  Corner: "Ecke",
  "crease-wheel": "Rillrad",
  cutter: "Fräser",
  knife: "Messer",
  laser: "Laser",
  "v-cutter": "V-Nut-Messer",
  "greatest deflection in X (mm)": "Größte Durchbiegung in X (mm)",
  "greatest deflection in Y (mm)": "Größte Durchbiegung in Y (mm)",
  "greatest feed (mm/min); 0: no limit": "Größter Vorschub (mm/min); 0: keine Grenze",
  "greatest depth of one pass of a cutter or a knife (mm); 0: no limit":
    "Größte Tiefe eines Durchgangs eines Fräsers oder Messers (mm); 0: keine Grenze",
  "radius of a curve below which the feed of a knife is lower in proportion to the radius (mm); 0: nowhere":
    "Kurvenradius, unter dem der Vorschub eines Messers im Verhältnis zum Radius kleiner ist (mm); 0: nirgends",
  Blade: "Klinge",
  "kind of knife that suits the board: a fixed or an oscillating blade; empty: any":
    "Messerart, die zum Material passt: feste oder oszillierende Klinge; leer: jede",
  Board: "Material",
  Material: "Material",
  "corrugated, folding boxboard, solid board, greyboard or foam board":
    "Wellpappe, Faltschachtelkarton, Vollpappe, Graupappe oder Schaumplatte",
  Caliper: "Materialdicke",
  "thickness (mm)": "Dicke (mm)",
  "Direction of flute or grain": "Wellen- oder Faserrichtung",
  "direction of flute or grain on the sheet (degrees)":
    "Richtung von Welle oder Faser auf dem Bogen (Grad)",
  "Crease along": "Rilltiefe längs",
  "depth of a crease along flute or grain (mm)": "Tiefe einer Rille längs zu Welle oder Faser (mm)",
  Creases: "Rillen",
  "Crease across": "Rilltiefe quer",
  "depth of a crease across flute or grain (mm)": "Tiefe einer Rille quer zu Welle oder Faser (mm)",
  "End clearance": "Freiraum an Enden",
  "distance between the end of a crease and the end of its line (mm)":
    "Abstand zwischen dem Ende einer Rille und dem Ende ihrer Linie (mm)",
  "Groove depth": "Nuttiefe",
  "depth of a V-groove below the top face (mm)": "Tiefe einer V-Nut unter der Oberseite (mm)",
  "V-grooves": "V-Nuten",
  "Groove overcut": "Überschnitt der Nut",
  "largest overcut of a V-groove (mm)": "Größter Überschnitt einer V-Nut (mm)",
  "Half-cut depth": "Ritztiefe",
  "depth of a half-cut below the top face (mm)": "Tiefe eines Ritzes unter der Oberseite (mm)",
  "Half-cuts and perforations": "Ritzen und Perforationen",
  Perforation: "Perforation",
  "length of cuts and of gaps (mm)": "Länge der Schnitte und der Lücken (mm)",
  "Length of cuts": "Länge der Schnitte",
  "Length of gaps": "Länge der Stege",
  "Creases shorter than the wheel": "Rillen, kürzer als das Rad",
  "whether a crease too short for the wheel is pressed at a smaller depth, or refused":
    "Ob eine Rille, die für das Rad zu kurz ist, flacher gedrückt oder abgelehnt wird",
  "Bridge width": "Breite der Haltestege",
  "width of a bridge that holds the part (mm)": "Breite eines Haltestegs (mm)",
  Bridges: "Haltestege",
  "Bridge spacing": "Abstand der Haltestege",
  "largest distance between two bridges (mm)": "Größter Abstand zweier Haltestege (mm)",
  "Double crease": "Doppelrille",
  "distance between the two lines of a double crease (mm); 0: single":
    "Abstand der beiden Linien einer Doppelrille (mm); 0: einfach",
  "Depth of one groove pass": "Tiefe eines Nutdurchgangs",
  "largest depth of one pass of a groove (mm); 0: one pass":
    "Größte Tiefe eines Durchgangs einer Nut (mm); 0: ein Durchgang",
  "Tolerance of curved grooves": "Toleranz gebogener Nuten",
  "largest distance between an arc and its chords in a groove (mm)":
    "Größter Abstand zwischen einem Bogen und seinen Sehnen in einer Nut (mm)",
  "Shift of grooves beside cuts": "Verschiebung von Nuten neben Schnitten",
  "largest shift of a V-groove away from a cut beside it (mm); 0: none":
    "Größte Verschiebung einer V-Nut weg von einem Schnitt daneben (mm); 0: keine",
  "Fold angle": "Faltwinkel",
  "angle by which the board must fold at a V-groove (degrees)":
    "Winkel, um den sich das Material an einer V-Nut falten muss (Grad)",
  "Tolerance of bent creases": "Toleranz gebogener Rillen",
  "largest distance at which the wheel may press beside a bent crease (mm)":
    "Größter Abstand, in dem das Rad neben einer gebogenen Rille drücken darf (mm)",
  "Tolerance of bent cuts": "Toleranz gebogener Schnitte",
  "largest distance between a bent cut in the top face and its line (mm)":
    "Größter Abstand zwischen einem gebogenen Schnitt in der Oberseite und seiner Linie (mm)",
  "Bends of cuts": "Biegungen von Schnitten",
  "Least radius of a bend": "Kleinster Biegeradius",
  "smallest radius of a bend that a knife cuts (mm); 0: no limit":
    "Kleinster Radius einer Biegung, die ein Messer schneidet (mm); 0: keine Grenze",
  Deflection: "Durchbiegung",
  "deflection of each tool, by the name of its station":
    "Durchbiegung jedes Werkzeugs, nach dem Namen seiner Station",
  "Deflection of cutters": "Durchbiegung von Fräsern",
  Limits: "Grenzen",
  "limits of each kind of tool, such as knife or cutter, in the board":
    "Grenzen jeder Werkzeugart im Material, zum Beispiel Messer oder Fräser",
  "Limits of tools": "Grenzen der Werkzeuge",
  "Name of the station": "Name der Station",
  "Kind of tool": "Werkzeugart",
  // Values of choices.
  manual: "manuell",
  automatic: "automatisch",
  rigid: "starr",
  soft: "weich",
  arcs: "Bögen",
  chords: "Sehnen",
  corner: "Ecke",
  centre: "Mitte",
  press: "drücken",
  refuse: "ablehnen",
  fixed: "fest",
  oscillating: "oszillierend",
  cut: "Schnitt",
  "half-cut": "Ritz",
  crease: "Rille",
  Length: "Länge",
  Depth: "Höhe",
  "Glue flap": "Klebelasche",
  "Tuck flap": "Einstecklasche",
  Lids: "Deckel",
  Part: "Teil",
  "Gap of the flaps": "Abstand der Klappen",
  "Covered part of the depth": "Überdeckter Teil der Höhe",
  "Inner length (mm): the side at which the lid or the outer flaps fold":
    "Innere Länge (mm): die Seite, an der der Deckel oder die Außenklappen falten",
  "Inner width (mm)": "Innere Breite (mm)",
  "Inner depth, from base to top (mm)": "Innere Höhe, vom Boden bis oben (mm)",
  "Width of the glue flap (mm)": "Breite der Klebelasche (mm)",
  "Distance between the outer flaps when the case is closed (mm)":
    "Abstand der Außenklappen bei geschlossener Kiste (mm)",
  "Length of the tuck flap of the lid (mm)": "Länge der Einstecklasche des Deckels (mm)",
  "Whether the lids hang on opposite panels (reverse) or on one (straight)":
    "Ob die Deckel an gegenüberliegenden Wänden hängen oder an derselben",
  reverse: "gegenüber",
  straight: "auf einer Seite",
  "Part to draw: the base with the inner dimensions, or the lid that fits over this base":
    "Teil, der gezeichnet wird: das Unterteil mit den Innenmaßen oder der Deckel, der darüber passt",
  base: "Unterteil",
  lid: "Deckel",
  "Depth of the lid as a part of the outer depth of the base, 0.1 to 1":
    "Höhe des Deckels als Teil der äußeren Höhe des Unterteils, 0,1 bis 1",
  "Accuracy of reading": "Ablesegenauigkeit",
  "How exactly you can read the measures (mm): about 0.1 with a ruler, 0.05 with a calliper, 0.02 with a measuring loupe":
    "Wie genau die Maße abgelesen werden (mm): etwa 0,1 mit einem Lineal, 0,05 mit einem Messschieber, 0,02 mit einer Messlupe",
  "b, distance of the two cuts at the bottom": "b, Abstand der beiden Schnitte am Grund",
  "At the board's edge, at the bottom of the groove (mm): positive if board is left between the cuts, negative if they cross each other":
    "Am Rand, am Grund der Nut (mm): positiv, wenn zwischen den Schnitten Material bleibt, negativ, wenn sie sich kreuzen",
  "M, length of one cut of the inner groove": "M, Länge eines Schnitts der inneren Nut",
  "In the top face, from the start to the end of one flank (mm); the line is 60 mm long. Empty if it was not measured":
    "An der Oberseite, vom Anfang bis zum Ende einer Flanke (mm); die Linie ist 60 mm lang. Leer, wenn nicht gemessen",
  "N, number of the first cut that goes through": "N, Nummer des ersten Schnitts, der durchgeht",
  "Counted from the cut-off corner; each fifth cut is longer. 0 if none goes through":
    "Von der abgeschnittenen Ecke an gezählt; jeder fünfte Schnitt ist länger. 0, wenn keiner durchgeht",
  "T, thickness of this board": "T, Dicke dieses Materials",
  "Measured at this sheet (mm); empty for the thickness in the file of the board":
    "An diesem Bogen gemessen (mm); leer für die Dicke in der Datei des Materials",
  "A1, first good flap along the grain": "A1, erste gute Lasche längs",
  "A2, last good flap along the grain": "A2, letzte gute Lasche längs",
  "B1, first good flap across the grain": "B1, erste gute Lasche quer",
  "B2, last good flap across the grain": "B2, letzte gute Lasche quer",
  "Comb A: number of the first flap that folds without springing back. Empty if this comb was not judged":
    "Kamm A: Nummer der ersten Lasche, die ohne Rückfedern faltet. Leer, wenn nicht beurteilt",
  "Comb A: number of the last flap that folds without a crack":
    "Kamm A: Nummer der letzten Lasche, die ohne Riss faltet",
  "Comb B: number of the first flap that folds without springing back. Empty if this comb was not judged":
    "Kamm B: Nummer der ersten Lasche, die ohne Rückfedern faltet. Leer, wenn nicht beurteilt",
  "Comb B: number of the last flap that folds without a crack":
    "Kamm B: Nummer der letzten Lasche, die ohne Riss faltet",
  "w, width": "w, Breite",
  "h, height": "h, Höhe",
  "Side along X (mm)": "Seite längs X (mm)",
  "Side along Y (mm)": "Seite längs Y (mm)",
  "Side along X (mm); drawn 200 mm": "Seite längs X (mm); gezeichnet 200 mm",
  "Side along Y (mm); drawn 150 mm": "Seite längs Y (mm); gezeichnet 150 mm",
  "p, first diagonal": "p, erste Diagonale",
  "q, second diagonal": "q, zweite Diagonale",
  "From the lower left corner, beside which there is a slit, to the upper right (mm)":
    "Von der linken unteren Ecke, neben der ein Schlitz ist, nach rechts oben (mm)",
  "From the upper left corner to the lower right (mm)":
    "Von der linken oberen Ecke nach rechts unten (mm)",
  "x, distance of the upright lines": "x, Abstand der senkrechten Linien",
  "y, distance of the level lines": "y, Abstand der waagerechten Linien",
  "From the cut to the middle of the line of the tool (mm); drawn 20 mm":
    "Vom Schnitt bis zur Mitte der Linie des Werkzeugs (mm); gezeichnet 20 mm",
};
