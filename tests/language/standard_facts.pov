// ior.inc and sunpos.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#include "ior.inc"

Show(iorAgate) Show(dispAgate) Show(iorAlexandrite) Show(dispAlexandrite) Show(iorAmber) Show(iorAmethyst) Show(dispAmethyst)
Show(iorAndalusite) Show(dispAndalusite) Show(iorApatite) Show(dispApatite) Show(iorAquamarine) Show(dispAquamarine) Show(iorBeryl)
Show(dispBeryl) Show(iorChalcedony) Show(dispChalcedony) Show(iorChrysoberyl) Show(dispChrysoberyl) Show(iorCitrine) Show(dispCitrine)
Show(iorCoral) Show(iorCorundum) Show(dispCorundum) Show(iorCrownGlass) Show(dispCrownGlass) Show(iorCubicZirconia) Show(dispCubicZirconia)
Show(iorDiamond) Show(dispDiamond) Show(iorEmerald) Show(dispEmerald) Show(iorFlintGlass) Show(dispFlintGlass) Show(iorFluorite)
Show(dispFluorite) Show(iorGlass) Show(dispGlass) Show(iorHiddenite) Show(dispHiddenite) Show(iorIolite) Show(dispIolite)
Show(iorIvory) Show(iorKunzite) Show(dispKunzite) Show(iorLabradorite) Show(iorLapisLazuli) Show(iorMalachite) Show(iorMoissanite)
Show(iorOnyx) Show(dispOnyx) Show(iorOpal) Show(iorOrthoclase) Show(iorPearl) Show(iorPeridot) Show(dispPeridot) Show(iorPrehnite)
Show(iorQuartz) Show(dispQuartz) Show(iorRuby) Show(dispRuby) Show(iorSapphire) Show(dispSapphire) Show(iorSphene) Show(dispSphene)
Show(iorSpinel) Show(dispSpinel) Show(iorSpodumene) Show(dispSpodumene) Show(iorTanzanite) Show(dispTanzanite) Show(iorTopaz)
Show(dispTopaz) Show(iorTourmaline) Show(dispTourmaline) Show(iorTurquoise) Show(iorWindowGlass) Show(dispWindowGlass) Show(iorZircon)
Show(dispZircon) Show(iorZoisite) Show(dispZoisite)

#include "sunpos.inc"
#macro Sun(A, B, C, D, E, F, G, H)
  #local V = SunPos(A, B, C, D, E, F, G, H);
  #debug concat(vstr(3, V/1e9, ", ", 0, 6), " ", str(Al, 0, 6), " ", str(Az, 0, 6), " ", str(vlength(V - SolarPosition), 0, 3), "\n")
#end
Sun(2000, 6, 21, 12, 2, 0, 51.4667, 0) Sun(2000, 1, 1, 12, 0, 0, 0, 0) Sun(2024, 3, 20, 8, 30, 15, 48.2, 16.4)
Sun(1995, 11, 5, 17, 15, -75, 40.7, -74) Sun(2010, 7, 1, 23, 59, 150, -33, 151) Sun(2000, 12, 31, 0, 0, 0, 90, 0)
Sun(2050, 2, 28, 6, 45, 120, -80, 100) Sun(1900, 5, 5, 5, 5, 5, 5, 5)

sphere { 0, 1 }
