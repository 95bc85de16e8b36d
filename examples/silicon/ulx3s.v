// The pattern on a ULX3S: a VGA Pmod with 4 bits a colour at the header of the pins gp and gn (ulx3s.lpf).
`default_nettype none

module ulx3s #(
    parameter LATENCY = 2
) (
    input wire clk_25mhz,
    output reg [3:0] red, green, blue,
    output reg across, down
);
  wire [7:0] grey;
  wire next_across, next_down, shown;
  pattern #(.LATENCY(LATENCY)) of_noise (
      .clock(clk_25mhz), .grey(grey), .across(next_across), .down(next_down), .shown(shown)
  );
  always @(posedge clk_25mhz) begin
    red <= shown ? grey[7:4] : 4'd0;
    green <= shown ? grey[7:4] : 4'd0;
    blue <= shown ? grey[7:4] : 4'd0;
    across <= next_across;
    down <= next_down;
  end
  wire unused = &{1'b0, grey[3:0]};
endmodule

`default_nettype wire
