interface Window {
  hexalab: import("../../static/viewer/app/api.js").HexaLab;
}
