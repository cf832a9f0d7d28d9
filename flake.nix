{
  description = "Ladder logic as plain text: checker, formatter, simulator and language server";

  inputs.nixpkgs.url = "github:NixOS/nixpkgs/nixos-unstable";

  outputs =
    { self, nixpkgs }:
    let
      manifest = (nixpkgs.lib.importTOML ./Cargo.toml).workspace.package;
      systems = [
        "x86_64-linux"
        "aarch64-linux"
        "x86_64-darwin"
        "aarch64-darwin"
      ];
      forEach = make: nixpkgs.lib.genAttrs systems (system: make nixpkgs.legacyPackages.${system});
    in
    {
      packages = forEach (pkgs: {
        default = pkgs.rustPlatform.buildRustPackage {
          pname = "ladder-logic";
          inherit (manifest) version;
          src = self;
          cargoLock.lockFile = ./Cargo.lock;
          cargoBuildFlags = [ "--package=ladder-cli" ];
          cargoTestFlags = [
            "--package=ladder-syntax"
            "--package=ladder-format"
            "--package=ladder-analysis"
          ];
          # Git is not there while it is built.
          LADDER_COMMIT = self.rev or "";
          # For the licences of the dependencies.
          nativeBuildInputs = [ pkgs.nodejs ];
          postInstall = ''
            patchShebangs packages
            packages/stage $out/bin staged
            cp -R staged/share $out
          '';
          meta = {
            inherit (manifest) description;
            homepage = manifest.repository;
            license = with pkgs.lib.licenses; [
              mit
              asl20
            ];
            mainProgram = "ladder";
          };
        };
      });

      devShells = forEach (pkgs: {
        default = pkgs.mkShell {
          packages = with pkgs; [
            cargo
            rustc
            rustfmt
            clippy
            nodejs
            python3
          ];
        };
      });
    };
}
