const Ag="uplot",Rg="u-hz",Cg="u-vt",Pg="u-title",Lg="u-wrap",Dg="u-under",Ig="u-over",Ng="u-axis",Is="u-off",Ug="u-select",kg="u-cursor-x",Fg="u-cursor-y",Og="u-cursor-pt",Bg="u-legend",zg="u-live",Hg="u-inline",Vg="u-series",Gg="u-marker",Eu="u-label",Wg="u-value",pr="width",mr="height";const Tu="bottom",lo="left",ml="right",vh="#000",Au=vh+"0",gl="mousemove",Ru="mousedown",_l="mouseup",Cu="mouseenter",Pu="mouseleave",Lu="dblclick",$g="resize",qg="scroll",Du="change",Ta="dppxchange",xh="--",Xo=typeof window<"u",lc=Xo?document:null,Po=Xo?window:null,Xg=Xo?navigator:null;let we,Or;function cc(){let i=devicePixelRatio;we!=i&&(we=i,Or&&uc(Du,Or,cc),Or=matchMedia(`(min-resolution: ${we-.001}dppx) and (max-resolution: ${we+.001}dppx)`),Bs(Du,Or,cc),Po.dispatchEvent(new CustomEvent(Ta)))}function On(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function hc(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Fe(i,t,e){i.style[t]=e+"px"}function ei(i,t,e,n){let s=lc.createElement(i);return t!=null&&On(s,t),e?.insertBefore(s,n),s}function qn(i,t){return ei("div",i,t)}const Iu=new WeakMap;function _i(i,t,e,n,s){let o="translate("+t+"px,"+e+"px)",r=Iu.get(i);o!=r&&(i.style.transform=o,Iu.set(i,o),t<0||e<0||t>n||e>s?On(i,Is):hc(i,Is))}const Nu=new WeakMap;function Uu(i,t,e){let n=t+e,s=Nu.get(i);n!=s&&(Nu.set(i,n),i.style.background=t,i.style.borderColor=e)}const ku=new WeakMap;function Fu(i,t,e,n){let s=t+""+e,o=ku.get(i);s!=o&&(ku.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}const bh={passive:!0},jg={...bh,capture:!0};function Bs(i,t,e,n){t.addEventListener(i,e,n?jg:bh)}function uc(i,t,e,n){t.removeEventListener(i,e,bh)}Xo&&cc();function si(i,t,e,n){let s;e=e||0,n=n||t.length-1;let o=n<=2147483647;for(;n-e>1;)s=o?e+n>>1:zn((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function sp(i){return(e,n,s)=>{let o=-1,r=-1;for(let a=n;a<=s;a++)if(i(e[a])){o=a;break}for(let a=s;a>=n;a--)if(i(e[a])){r=a;break}return[o,r]}}const op=i=>i!=null,rp=i=>i!=null&&i>0,Va=sp(op),Yg=sp(rp);function Kg(i,t,e,n=0,s=!1){let o=s?Yg:Va,r=s?rp:op;[t,e]=o(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];r(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Le,l??-Le]}function Ga(i,t,e,n){let s=zu(i),o=zu(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let r=e==10?Bi:ap,a=s==1?zn:Xn,l=o==1?Xn:zn,c=a(r(tn(i))),h=l(r(tn(t))),u=No(e,c),d=No(e,h);return e==10&&(c<0&&(u=De(u,-c)),h<0&&(d=De(d,-h))),n||e==2?(i=u*s,t=d*o):(i=up(i,u),t=Wa(t,d)),[i,t]}function yh(i,t,e,n){let s=Ga(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}const Mh=.1,Ou={mode:3,pad:Mh},br={pad:0,soft:null,mode:0},Zg={min:br,max:br};function Aa(i,t,e,n){return $a(e)?Bu(i,t,e):(br.pad=e,br.soft=n?0:null,br.mode=n?3:0,Bu(i,t,Zg))}function ye(i,t){return i??t}function Jg(i,t,e){for(t=ye(t,0),e=ye(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Bu(i,t,e){let n=e.min,s=e.max,o=ye(n.pad,0),r=ye(s.pad,0),a=ye(n.hard,-Le),l=ye(s.hard,Le),c=ye(n.soft,Le),h=ye(s.soft,-Le),u=ye(n.mode,0),d=ye(s.mode,0),p=t-i,_=Bi(p),g=En(tn(i),tn(t)),m=Bi(g),f=tn(m-_);(p<1e-24||f>10)&&(p=0,(i==0||t==0)&&(p=1e-24,u==2&&c!=Le&&(o=0),d==2&&h!=-Le&&(r=0)));let M=p||g||1e3,S=Bi(M),x=No(10,zn(S)),k=M*(p==0?i==0?.1:1:o),P=De(up(i-k,x/10),24),A=i>=c&&(u==1||u==3&&P<=c||u==2&&P>=c)?c:Le,I=En(a,P<A&&i>=A?A:oi(A,P)),E=M*(p==0?t==0?.1:1:r),b=De(Wa(t+E,x/10),24),R=t<=h&&(d==1||d==3&&b>=h||d==2&&b<=h)?h:-Le,H=oi(l,b>R&&t<=R?R:En(R,b));return I==H&&I==0&&(H=100),[I,H]}const Qg=new Intl.NumberFormat(Xo?Xg.language:"en-US"),Sh=i=>Qg.format(i),Hn=Math,ga=Hn.PI,tn=Hn.abs,zn=Hn.floor,Je=Hn.round,Xn=Hn.ceil,oi=Hn.min,En=Hn.max,No=Hn.pow,zu=Hn.sign,Bi=Hn.log10,ap=Hn.log2,t0=(i,t=1)=>Hn.sinh(i)*t,vl=(i,t=1)=>Hn.asinh(i/t),Le=1/0;function Hu(i){return(Bi((i^i>>31)-(i>>31))|0)+1}function dc(i,t,e){return oi(En(i,t),e)}function lp(i){return typeof i=="function"}function le(i){return lp(i)?i:()=>i}const e0=()=>{},cp=i=>i,hp=(i,t)=>t,n0=i=>null,Vu=i=>!0,Gu=(i,t)=>i==t,i0=/\.\d*?(?=9{6,}|0{6,})/gm,Gs=i=>{if(fp(i)||cs.has(i))return i;const t=`${i}`,e=t.match(i0);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,o]=t.split("e");return+`${Gs(s)}e${o}`}return De(i,n)};function Ps(i,t){return Gs(De(Gs(i/t))*t)}function Wa(i,t){return Gs(Xn(Gs(i/t))*t)}function up(i,t){return Gs(zn(Gs(i/t))*t)}function De(i,t=0){if(fp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Je(n)/e}const cs=new Map;function dp(i){return((""+i).split(".")[1]||"").length}function Sr(i,t,e,n){let s=[],o=n.map(dp);for(let r=t;r<e;r++){let a=tn(r),l=De(No(i,r),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${r}`:n[c]*l,u=(r>=0?0:a)+(r>=o[c]?0:o[c]),d=i==10?h:De(h,u);s.push(d),cs.set(d,u)}}return s}const yr={},wh=[],Uo=[null,null],ns=Array.isArray,fp=Number.isInteger,s0=i=>i===void 0;function Wu(i){return typeof i=="string"}function $a(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function o0(i){return i!=null&&typeof i=="object"}const r0=Object.getPrototypeOf(Uint8Array),pp="__proto__";function ko(i,t=$a){let e;if(ns(i)){let n=i.find(s=>s!=null);if(ns(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=ko(i[s],t)}else e=i.slice()}else if(i instanceof r0)e=i.slice();else if(t(i)){e={};for(let n in i)n!=pp&&(e[n]=ko(i[n],t))}else e=i;return e}function je(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=pp&&($a(i[s])?je(i[s],ko(n[s])):i[s]=ko(n[s]))}return i}const a0=0,l0=1,c0=2;function h0(i,t,e){for(let n=0,s,o=-1;n<t.length;n++){let r=t[n];if(r>o){for(s=r-1;s>=0&&i[s]==null;)i[s--]=null;for(s=r+1;s<e&&i[s]==null;)i[o=s++]=null}}}function u0(i,t){if(p0(i)){let r=i[0].slice();for(let a=1;a<i.length;a++)r.push(...i[a].slice(1));return m0(r[0])||(r=f0(r)),r}let e=new Set;for(let r=0;r<i.length;r++){let l=i[r][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((r,a)=>r-a)],s=n[0].length,o=new Map;for(let r=0;r<s;r++)o.set(n[0][r],r);for(let r=0;r<i.length;r++){let a=i[r],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=t?t[r][c]:l0,p=[];for(let _=0;_<h.length;_++){let g=h[_],m=o.get(l[_]);g===null?d!=a0&&(u[m]=g,d==c0&&p.push(m)):u[m]=g}h0(u,p,s),n.push(u)}}return n}const d0=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function f0(i){let t=i[0],e=t.length,n=Array(e);for(let o=0;o<n.length;o++)n[o]=o;n.sort((o,r)=>t[o]-t[r]);let s=[];for(let o=0;o<i.length;o++){let r=i[o],a=Array(e);for(let l=0;l<e;l++)a[l]=r[n[l]];s.push(a)}return s}function p0(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let o=0;o<e;o++)if(s[o]!=t[o])return!1}}return!0}function m0(i,t=100){const e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const o=En(1,zn((s-n+1)/t));for(let r=i[n],a=n+o;a<=s;a+=o){const l=i[a];if(l!=null){if(l<=r)return!1;r=l}}return!0}const mp=["January","February","March","April","May","June","July","August","September","October","November","December"],gp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function _p(i){return i.slice(0,3)}const g0=gp.map(_p),_0=mp.map(_p),v0={MMMM:mp,MMM:_0,WWWW:gp,WWW:g0};function rr(i){return(i<10?"0":"")+i}function x0(i){return(i<10?"00":i<100?"0":"")+i}const b0={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>rr(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>rr(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>rr(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>rr(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>rr(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>x0(i.getMilliseconds())};function Eh(i,t){t=t||v0;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?b0[s[1]]:s[0]);return o=>{let r="";for(let a=0;a<e.length;a++)r+=typeof e[a]=="string"?e[a]:e[a](o,t);return r}}const y0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function M0(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==y0?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}const vp=i=>i%1==0,Ra=[1,2,2.5,5],S0=Sr(10,-32,0,Ra),xp=Sr(10,0,32,Ra),w0=xp.filter(vp),Ls=S0.concat(xp),Th=`
`,bp="{YYYY}",$u=Th+bp,yp="{M}/{D}",gr=Th+yp,Br=gr+"/{YY}",Mp="{aa}",E0="{h}:{mm}",Ao=E0+Mp,qu=Th+Ao,Xu=":{ss}",Te=null;function Sp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,o=s*30,r=s*365,l=(i==1?Sr(10,0,3,Ra).filter(vp):Sr(10,-3,0,Ra)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,o,o*2,o*3,o*4,o*6,r,r*2,r*5,r*10,r*25,r*50,r*100]);const c=[[r,bp,Te,Te,Te,Te,Te,Te,1],[s*28,"{MMM}",$u,Te,Te,Te,Te,Te,1],[s,yp,$u,Te,Te,Te,Te,Te,1],[n,"{h}"+Mp,Br,Te,gr,Te,Te,Te,1],[e,Ao,Br,Te,gr,Te,Te,Te,1],[t,Xu,Br+" "+Ao,Te,gr+" "+Ao,Te,qu,Te,1],[i,Xu+".{fff}",Br+" "+Ao,Te,gr+" "+Ao,Te,qu,Te,1]];function h(u){return(d,p,_,g,m,f)=>{let M=[],S=m>=r,x=m>=o&&m<r,k=u(_),P=De(k*i,3),A=xl(k.getFullYear(),S?0:k.getMonth(),x||S?1:k.getDate()),I=De(A*i,3);if(x||S){let E=x?m/o:0,b=S?m/r:0,R=P==I?P:De(xl(A.getFullYear()+b,A.getMonth()+E,1)*i,3),H=new Date(Je(R/i)),O=H.getFullYear(),q=H.getMonth();for(let $=0;R<=g;$++){let X=xl(O+b*$,q+E*$,1),j=X-u(De(X*i,3));R=De((+X+j)*i,3),R<=g&&M.push(R)}}else{let E=m>=s?s:m,b=zn(_)-zn(P),R=I+b+Wa(P-I,E);M.push(R);let H=u(R),O=H.getHours()+H.getMinutes()/e+H.getSeconds()/n,q=m/n,$=d.axes[p]._space,X=f/$;for(;R=De(R+m,i==1?0:3),!(R>g);)if(q>1){let j=zn(De(O+q,6))%24,lt=u(R).getHours()-j;lt>1&&(lt=-1),R-=lt*n,O=(O+q)%24;let gt=M[M.length-1];De((R-gt)/m,3)*X>=.7&&M.push(R)}else M.push(R)}return M}}return[l,c,h]}const[T0,A0,R0]=Sp(1),[C0,P0,L0]=Sp(.001);Sr(2,-53,53,[1]);function ju(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Yu(i,t){return(e,n,s,o,r)=>{let a=t.find(_=>r>=_[0])||t[t.length-1],l,c,h,u,d,p;return n.map(_=>{let g=i(_),m=g.getFullYear(),f=g.getMonth(),M=g.getDate(),S=g.getHours(),x=g.getMinutes(),k=g.getSeconds(),P=m!=l&&a[2]||f!=c&&a[3]||M!=h&&a[4]||S!=u&&a[5]||x!=d&&a[6]||k!=p&&a[7]||a[1];return l=m,c=f,h=M,u=S,d=x,p=k,P(g)})}}function D0(i,t){let e=Eh(t);return(n,s,o,r,a)=>s.map(l=>e(i(l)))}function xl(i,t,e){return new Date(i,t,e)}function Ku(i,t){return t(i)}const I0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Zu(i,t){return(e,n,s,o)=>o==null?xh:t(i(n))}function N0(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function U0(i,t){return i.series[t].fill(i,t)}const k0={show:!0,live:!0,isolate:!1,mount:e0,markers:{show:!0,width:2,stroke:N0,fill:U0,dash:"solid"},idx:null,idxs:null,values:[]};function F0(i,t){let e=i.cursor.points,n=qn(),s=e.size(i,t);Fe(n,pr,s),Fe(n,mr,s);let o=s/-2;Fe(n,"marginLeft",o),Fe(n,"marginTop",o);let r=e.width(i,t,s);return r&&Fe(n,"borderWidth",r),n}function O0(i,t){let e=i.series[t].points;return e._fill||e._stroke}function B0(i,t){let e=i.series[t].points;return e._stroke||e._fill}function z0(i,t){return i.series[t].points.size}const bl=[0,0];function H0(i,t,e){return bl[0]=t,bl[1]=e,bl}function zr(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function yl(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}const V0={show:!0,x:!0,y:!0,lock:!1,move:H0,points:{one:!1,show:F0,size:z0,width:0,stroke:B0,fill:O0},bind:{mousedown:zr,mouseup:zr,click:zr,dblclick:zr,mousemove:yl,mouseleave:yl,mouseenter:yl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},wp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ah=je({},wp,{filter:hp}),Ep=je({},Ah,{size:10}),Tp=je({},wp,{show:!1}),Rh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Ap="bold "+Rh,Rp=1.5,Ju={show:!0,scale:"x",stroke:vh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ap,side:2,grid:Ah,ticks:Ep,border:Tp,font:Rh,lineGap:Rp,rotate:0},G0="Value",W0="Time",Qu={show:!0,scale:"x",auto:!1,sorted:1,min:Le,max:-Le,idxs:[]};function $0(i,t,e,n,s){return t.map(o=>o==null?"":Sh(o))}function q0(i,t,e,n,s,o,r){let a=[],l=cs.get(s)||0;e=r?e:De(Wa(e,s),l);for(let c=e;c<=n;c=De(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function fc(i,t,e,n,s,o,r){const a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Bi:ap,h=zn(c(e));s=No(l,h),l==10&&(s=Ls[si(s,Ls)]);let u=e,d=s*l;l==10&&(d=Ls[si(d,Ls)]);do a.push(u),u=u+s,l==10&&!cs.has(u)&&(u=De(u,cs.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Ls[si(d,Ls)]));while(u<=n);return a}function X0(i,t,e,n,s,o,r){let l=i.scales[i.axes[t].scale].asinh,c=n>l?fc(i,t,En(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?fc(i,t,En(l,-n),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}const Cp=/./,j0=/[12357]/,Y0=/[125]/,td=/1/,pc=(i,t,e,n)=>i.map((s,o)=>t==4&&s==0||o%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function K0(i,t,e,n,s){let o=i.axes[e],r=o.scale,a=i.scales[r],l=i.valToPos,c=o._space,h=l(10,r),u=l(9,r)-h>=c?Cp:l(7,r)-h>=c?j0:l(5,r)-h>=c?Y0:td;if(u==td){let d=tn(l(1,r)-h);if(d<c)return pc(t.slice().reverse(),a.distr,u,Xn(c/d)).reverse()}return pc(t,a.distr,u,1)}function Z0(i,t,e,n,s){let o=i.axes[e],r=o.scale,a=o._space,l=i.valToPos,c=tn(l(1,r)-l(2,r));return c<a?pc(t.slice().reverse(),3,Cp,Xn(a/c)).reverse():t}function J0(i,t,e,n){return n==null?xh:t==null?"":Sh(t)}const ed={show:!0,scale:"y",stroke:vh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ap,side:3,grid:Ah,ticks:Ep,border:Tp,font:Rh,lineGap:Rp,rotate:0};function Q0(i,t){let e=3+(i||1)*2;return De(e*t,3)}function t_(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],o=i.valToPos(s[n[0]],e,!0),r=i.valToPos(s[n[1]],e,!0),a=tn(r-o),l=i.series[t],c=a/(l.points.space*we);return n[1]-n[0]<=c}const nd={scale:null,auto:!0,sorted:0,min:Le,max:-Le},Pp=(i,t,e,n,s)=>s,id={show:!0,auto:!0,sorted:0,gaps:Pp,alpha:1,facets:[je({},nd,{scale:"x"}),je({},nd,{scale:"y"})]},sd={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Pp,alpha:1,points:{show:t_,filter:null},values:null,min:Le,max:-Le,idxs:[],path:null,clip:null};function e_(i,t,e,n,s){return e/10}const Lp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},n_=je({},Lp,{time:!1,ori:1}),od={};function Dp(i,t){let e=od[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,o,r,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,o,r,a,l,c)}},i!=null&&(od[i]=e)),e}const Fo=1,mc=2;function Ys(i,t,e){const n=i.mode,s=i.series[t],o=n==2?i._data[t]:i._data,r=i.scales,a=i.bbox;let l=o[0],c=n==2?o[1]:o[t],h=n==2?r[s.facets[0].scale]:r[i.series[0].scale],u=n==2?r[s.facets[1].scale]:r[s.scale],d=a.left,p=a.top,_=a.width,g=a.height,m=i.valToPosH,f=i.valToPosV;return h.ori==0?e(s,l,c,h,u,m,f,d,p,_,g,Xa,jo,Ya,Np,kp):e(s,l,c,h,u,f,m,p,d,g,_,ja,Yo,Lh,Up,Fp)}function Ch(i,t){let e=0,n=0,s=ye(i.bands,wh);for(let o=0;o<s.length;o++){let r=s[o];r.series[0]==t?e=r.dir:r.series[1]==t&&(r.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function i_(i,t,e,n,s){let o=i.mode,r=i.series[t],a=o==2?r.facets[1].scale:r.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function zi(i,t,e,n,s,o){return Ys(i,t,(r,a,l,c,h,u,d,p,_,g,m)=>{let f=r.pxRound;const M=c.dir*(c.ori==0?1:-1),S=c.ori==0?jo:Yo;let x,k;M==1?(x=e,k=n):(x=n,k=e);let P=f(u(a[x],c,g,p)),A=f(d(l[x],h,m,_)),I=f(u(a[k],c,g,p)),E=f(d(o==1?h.max:h.min,h,m,_)),b=new Path2D(s);return S(b,I,E),S(b,P,E),S(b,P,A),b})}function qa(i,t,e,n,s,o){let r=null;if(i.length>0){r=new Path2D;const a=t==0?Ya:Lh;let l=e;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let p=d[0]-l;p>0&&a(r,l,n,p,n+o),l=d[1]}}let c=e+s-l,h=10;c>0&&a(r,l,n-h/2,c,n+o+h)}return r}function s_(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Ph(i,t,e,n,s,o,r){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let p=o(i[u]),_=d==u?p:o(i[d]),g=u-s;p=r<=0&&g>=0&&g<l?o(i[g]):p;let f=d+s;_=r>=0&&f>=0&&f<l?o(i[f]):_,_>=p&&a.push([p,_])}return a}function rd(i){return i==0?cp:i==1?Je:t=>Ps(t,i)}function Ip(i){let t=i==0?Xa:ja,e=i==0?(s,o,r,a,l,c)=>{s.arcTo(o,r,a,l,c)}:(s,o,r,a,l,c)=>{s.arcTo(r,o,l,a,c)},n=i==0?(s,o,r,a,l)=>{s.rect(o,r,a,l)}:(s,o,r,a,l)=>{s.rect(r,o,l,a)};return(s,o,r,a,l,c=0,h=0)=>{c==0&&h==0?n(s,o,r,a,l):(c=oi(c,a/2,l/2),h=oi(h,a/2,l/2),t(s,o+c,r),e(s,o+a,r,o+a,r+l,c),e(s,o+a,r+l,o,r+l,h),e(s,o,r+l,o,r,h),e(s,o,r,o+a,r,c),s.closePath())}}const Xa=(i,t,e)=>{i.moveTo(t,e)},ja=(i,t,e)=>{i.moveTo(e,t)},jo=(i,t,e)=>{i.lineTo(t,e)},Yo=(i,t,e)=>{i.lineTo(e,t)},Ya=Ip(0),Lh=Ip(1),Np=(i,t,e,n,s,o)=>{i.arc(t,e,n,s,o)},Up=(i,t,e,n,s,o)=>{i.arc(e,t,n,s,o)},kp=(i,t,e,n,s,o,r)=>{i.bezierCurveTo(t,e,n,s,o,r)},Fp=(i,t,e,n,s,o,r)=>{i.bezierCurveTo(e,t,s,n,r,o)};function Op(i){return(t,e,n,s,o)=>Ys(t,e,(r,a,l,c,h,u,d,p,_,g,m)=>{let{pxRound:f,points:M}=r,S,x;c.ori==0?(S=Xa,x=Np):(S=ja,x=Up);const k=De(M.width*we,3);let P=(M.size-M.width)/2*we,A=De(P*2,3),I=new Path2D,E=new Path2D,{left:b,top:R,width:H,height:O}=t.bbox;Ya(E,b-A,R-A,H+A*2,O+A*2);const q=$=>{if(l[$]!=null){let X=f(u(a[$],c,g,p)),j=f(d(l[$],h,m,_));S(I,X+P,j),x(I,X,j,P,0,ga*2)}};if(o)o.forEach(q);else for(let $=n;$<=s;$++)q($);return{stroke:k>0?I:null,fill:I,clip:E,flags:Fo|mc}})}function Bp(i){return(t,e,n,s,o,r)=>{n!=s&&(o!=n&&r!=n&&i(t,e,n),o!=s&&r!=s&&i(t,e,s),i(t,e,r))}}const o_=Bp(jo),r_=Bp(Yo);function zp(i){const t=ye(i?.alignGaps,0);return(e,n,s,o)=>Ys(e,n,(r,a,l,c,h,u,d,p,_,g,m)=>{[s,o]=Va(l,s,o);let f=r.pxRound,M=O=>f(u(O,c,g,p)),S=O=>f(d(O,h,m,_)),x,k;c.ori==0?(x=jo,k=o_):(x=Yo,k=r_);const P=c.dir*(c.ori==0?1:-1),A={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},I=A.stroke;let E=!1;if(o-s>=g*4){let O=mt=>e.posToVal(mt,c.key,!0),q=null,$=null,X,j,Q,at=M(a[P==1?s:o]),lt=M(a[s]),gt=M(a[o]),xt=O(P==1?lt+1:gt-1);for(let mt=P==1?s:o;mt>=s&&mt<=o;mt+=P){let ot=a[mt],_t=(P==1?ot<xt:ot>xt)?at:M(ot),ht=l[mt];_t==at?ht!=null?(j=ht,q==null?(x(I,_t,S(j)),X=q=$=j):j<q?q=j:j>$&&($=j)):ht===null&&(E=!0):(q!=null&&k(I,at,S(q),S($),S(X),S(j)),ht!=null?(j=ht,x(I,_t,S(j)),q=$=X=j):(q=$=null,ht===null&&(E=!0)),at=_t,xt=O(at+P))}q!=null&&q!=$&&Q!=at&&k(I,at,S(q),S($),S(X),S(j))}else for(let O=P==1?s:o;O>=s&&O<=o;O+=P){let q=l[O];q===null?E=!0:q!=null&&x(I,M(a[O]),S(q))}let[R,H]=Ch(e,n);if(r.fill!=null||R!=0){let O=A.fill=new Path2D(I),q=r.fillTo(e,n,r.min,r.max,R),$=S(q),X=M(a[s]),j=M(a[o]);P==-1&&([j,X]=[X,j]),x(O,j,$),x(O,X,$)}if(!r.spanGaps){let O=[];E&&O.push(...Ph(a,l,s,o,P,M,t)),A.gaps=O=r.gaps(e,n,s,o,O),A.clip=qa(O,c.ori,p,_,g,m)}return H!=0&&(A.band=H==2?[zi(e,n,s,o,I,-1),zi(e,n,s,o,I,1)]:zi(e,n,s,o,I,H)),A})}function a_(i){const t=ye(i.align,1),e=ye(i.ascDesc,!1),n=ye(i.alignGaps,0),s=ye(i.extend,!1);return(o,r,a,l)=>Ys(o,r,(c,h,u,d,p,_,g,m,f,M,S)=>{[a,l]=Va(u,a,l);let x=c.pxRound,{left:k,width:P}=o.bbox,A=lt=>x(_(lt,d,M,m)),I=lt=>x(g(lt,p,S,f)),E=d.ori==0?jo:Yo;const b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},R=b.stroke,H=d.dir*(d.ori==0?1:-1);let O=I(u[H==1?a:l]),q=A(h[H==1?a:l]),$=q,X=q;s&&t==-1&&(X=k,E(R,X,O)),E(R,q,O);for(let lt=H==1?a:l;lt>=a&&lt<=l;lt+=H){let gt=u[lt];if(gt==null)continue;let xt=A(h[lt]),mt=I(gt);t==1?E(R,xt,O):E(R,$,mt),E(R,xt,mt),O=mt,$=xt}let j=$;s&&t==1&&(j=k+P,E(R,j,O));let[Q,at]=Ch(o,r);if(c.fill!=null||Q!=0){let lt=b.fill=new Path2D(R),gt=c.fillTo(o,r,c.min,c.max,Q),xt=I(gt);E(lt,j,xt),E(lt,X,xt)}if(!c.spanGaps){let lt=[];lt.push(...Ph(h,u,a,l,H,A,n));let gt=c.width*we/2,xt=e||t==1?gt:-gt,mt=e||t==-1?-gt:gt;lt.forEach(ot=>{ot[0]+=xt,ot[1]+=mt}),b.gaps=lt=c.gaps(o,r,a,l,lt),b.clip=qa(lt,d.ori,m,f,M,S)}return at!=0&&(b.band=at==2?[zi(o,r,a,l,R,-1),zi(o,r,a,l,R,1)]:zi(o,r,a,l,R,at)),b})}function ad(i,t,e,n,s,o,r=Le){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=tn(i[l]-i[a]);h<c&&(c=h,r=tn(e(i[l],n,s,o)-e(i[a],n,s,o)))}a=l}}return r}function l_(i){i=i||yr;const t=ye(i.size,[.6,Le,1]),e=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const o=le(s),r=1-t[0],a=ye(t[1],Le),l=ye(t[2],1),c=ye(i.disp,yr),h=ye(i.each,p=>{}),{fill:u,stroke:d}=c;return(p,_,g,m)=>Ys(p,_,(f,M,S,x,k,P,A,I,E,b,R)=>{let H=f.pxRound,O=e,q=n*we,$=a*we,X=l*we,j,Q;x.ori==0?[j,Q]=o(p,_):[Q,j]=o(p,_);const at=x.dir*(x.ori==0?1:-1);let lt=x.ori==0?Ya:Lh,gt=x.ori==0?h:(Y,it,St,bt,At,Zt,pt)=>{h(Y,it,St,At,bt,pt,Zt)},xt=ye(p.bands,wh).find(Y=>Y.series[0]==_),mt=xt!=null?xt.dir:0,ot=f.fillTo(p,_,f.min,f.max,mt),ut=H(A(ot,k,R,E)),_t,ht,Nt,zt=b,Ut=H(f.width*we),ce=!1,Jt=null,he=null,G=null,Ke=null;u!=null&&(Ut==0||d!=null)&&(ce=!0,Jt=u.values(p,_,g,m),he=new Map,new Set(Jt).forEach(Y=>{Y!=null&&he.set(Y,new Path2D)}),Ut>0&&(G=d.values(p,_,g,m),Ke=new Map,new Set(G).forEach(Y=>{Y!=null&&Ke.set(Y,new Path2D)})));let{x0:te,size:ie}=c;if(te!=null&&ie!=null){O=1,M=te.values(p,_,g,m),te.unit==2&&(M=M.map(St=>p.posToVal(I+St*b,x.key,!0)));let Y=ie.values(p,_,g,m);ie.unit==2?ht=Y[0]*b:ht=P(Y[0],x,b,I)-P(0,x,b,I),zt=ad(M,S,P,x,b,I,zt),Nt=zt-ht+q}else zt=ad(M,S,P,x,b,I,zt),Nt=zt*r+q,ht=zt-Nt;Nt<1&&(Nt=0),Ut>=ht/2&&(Ut=0),Nt<5&&(H=cp);let Wt=Nt>0,me=zt-Nt-(Wt?Ut:0);ht=H(dc(me,X,$)),_t=(O==0?ht/2:O==at?0:ht)-O*at*((O==0?q/2:0)+(Wt?Ut/2:0));const Dt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},D=ce?null:new Path2D;let w=null;if(xt!=null)w=p.data[xt.series[1]];else{let{y0:Y,y1:it}=c;Y!=null&&it!=null&&(S=it.values(p,_,g,m),w=Y.values(p,_,g,m))}let tt=j*ht,nt=Q*ht;for(let Y=at==1?g:m;Y>=g&&Y<=m;Y+=at){let it=S[Y];if(it==null)continue;if(w!=null){let Ht=w[Y]??0;if(it-Ht==0)continue;ut=A(Ht,k,R,E)}let St=x.distr!=2||c!=null?M[Y]:Y,bt=P(St,x,b,I),At=A(ye(it,ot),k,R,E),Zt=H(bt-_t),pt=H(En(At,ut)),yt=H(oi(At,ut)),Ot=pt-yt;if(it!=null){let Ht=it<0?nt:tt,Et=it<0?tt:nt;ce?(Ut>0&&G[Y]!=null&&lt(Ke.get(G[Y]),Zt,yt+zn(Ut/2),ht,En(0,Ot-Ut),Ht,Et),Jt[Y]!=null&&lt(he.get(Jt[Y]),Zt,yt+zn(Ut/2),ht,En(0,Ot-Ut),Ht,Et)):lt(D,Zt,yt+zn(Ut/2),ht,En(0,Ot-Ut),Ht,Et),gt(p,_,Y,Zt-Ut/2,yt,ht+Ut,Ot)}}return Ut>0?Dt.stroke=ce?Ke:D:ce||(Dt._fill=f.width==0?f._fill:f._stroke??f._fill,Dt.width=0),Dt.fill=ce?he:D,Dt})}function c_(i,t){const e=ye(t?.alignGaps,0);return(n,s,o,r)=>Ys(n,s,(a,l,c,h,u,d,p,_,g,m,f)=>{[o,r]=Va(c,o,r);let M=a.pxRound,S=j=>M(d(j,h,m,_)),x=j=>M(p(j,u,f,g)),k,P,A;h.ori==0?(k=Xa,A=jo,P=kp):(k=ja,A=Yo,P=Fp);const I=h.dir*(h.ori==0?1:-1);let E=S(l[I==1?o:r]),b=E,R=[],H=[];for(let j=I==1?o:r;j>=o&&j<=r;j+=I)if(c[j]!=null){let at=l[j],lt=S(at);R.push(b=lt),H.push(x(c[j]))}const O={stroke:i(R,H,k,A,P,M),fill:null,clip:null,band:null,gaps:null,flags:Fo},q=O.stroke;let[$,X]=Ch(n,s);if(a.fill!=null||$!=0){let j=O.fill=new Path2D(q),Q=a.fillTo(n,s,a.min,a.max,$),at=x(Q);A(j,b,at),A(j,E,at)}if(!a.spanGaps){let j=[];j.push(...Ph(l,c,o,r,I,S,e)),O.gaps=j=a.gaps(n,s,o,r,j),O.clip=qa(j,h.ori,_,g,m,f)}return X!=0&&(O.band=X==2?[zi(n,s,o,r,q,-1),zi(n,s,o,r,q,1)]:zi(n,s,o,r,q,X)),O})}function h_(i){return c_(u_,i)}function u_(i,t,e,n,s,o){const r=i.length;if(r<2)return null;const a=new Path2D;if(e(a,i[0],t[0]),r==2)n(a,i[1],t[1]);else{let l=Array(r),c=Array(r-1),h=Array(r-1),u=Array(r-1);for(let d=0;d<r-1;d++)h[d]=t[d+1]-t[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<r-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[r-1]=c[r-2];for(let d=0;d<r-1;d++)s(a,i[d]+u[d]/3,t[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,i[d+1],t[d+1])}return a}const gc=new Set;function ld(){for(let i of gc)i.syncRect(!0)}Xo&&(Bs($g,Po,ld),Bs(qg,Po,ld,!0),Bs(Ta,Po,()=>{xn.pxRatio=we}));const d_=zp(),f_=Op();function cd(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((o,r)=>_c(o,r,t,e))}function p_(i,t){return i.map((e,n)=>n==0?{}:je({},t,e))}function _c(i,t,e,n){return je({},t==0?e:n,i)}function Hp(i,t,e){return t==null?Uo:[t,e]}const m_=Hp;function g_(i,t,e){return t==null?Uo:Aa(t,e,Mh,!0)}function Vp(i,t,e,n){return t==null?Uo:Ga(t,e,i.scales[n].log,!1)}const __=Vp;function Gp(i,t,e,n){return t==null?Uo:yh(t,e,i.scales[n].log,!1)}const v_=Gp;function x_(i,t,e,n,s){let o=En(Hu(i),Hu(t)),r=t-i,a=si(s/n*r,e);do{let l=e[a],c=n*l/r;if(c>=s&&o+(l<5?cs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function hd(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Je((e=+s)*we))+"px"),[i,t,e]}function b_(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=De(t[2]*we,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function xn(i,t,e){const n={mode:ye(i.mode,1)},s=n.mode;function o(v,y,L,N){let B=y.valToPct(v);return N+L*(y.dir==-1?1-B:B)}function r(v,y,L,N){let B=y.valToPct(v);return N+L*(y.dir==-1?B:1-B)}function a(v,y,L,N){return y.ori==0?o(v,y,L,N):r(v,y,L,N)}n.valToPosH=o,n.valToPosV=r;let l=!1;n.status=0;const c=n.root=qn(Ag);if(i.id!=null&&(c.id=i.id),On(c,i.class),i.title){let v=qn(Pg,c);v.textContent=i.title}const h=ei("canvas"),u=n.ctx=h.getContext("2d"),d=qn(Lg,c);Bs("click",d,v=>{v.target===_&&(Ne!=io||ze!=so)&&dn.click(n,v)},!0);const p=n.under=qn(Dg,d);d.appendChild(h);const _=n.over=qn(Ig,d);i=ko(i);const g=+ye(i.pxAlign,1),m=rd(g);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});const f=i.ms||.001,M=n.series=s==1?cd(i.series||[],Qu,sd,!1):p_(i.series||[null],id),S=n.axes=cd(i.axes||[],Ju,ed,!0),x=n.scales={},k=n.bands=i.bands||[];k.forEach(v=>{v.fill=le(v.fill||null),v.dir=ye(v.dir,-1)});const P=s==2?M[1].facets[0].scale:M[0].scale,A={axes:dg,series:Vn},I=(i.drawOrder||["axes","series"]).map(v=>A[v]);function E(v){const y=v.distr==3?L=>Bi(L>0?L:v.clamp(n,L,v.min,v.max,v.key)):v.distr==4?L=>vl(L,v.asinh):v.distr==100?L=>v.fwd(L):L=>L;return L=>{let N=y(L),{_min:B,_max:J}=v,rt=J-B;return(N-B)/rt}}function b(v){let y=x[v];if(y==null){let L=(i.scales||yr)[v]||yr;if(L.from!=null){b(L.from);let N=je({},x[L.from],L,{key:v});N.valToPct=E(N),x[v]=N}else{y=x[v]=je({},v==P?Lp:n_,L),y.key=v;let N=y.time,B=y.range,J=ns(B);if((v!=P||s==2&&!N)&&(J&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?Ou:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?Ou:{mode:1,hard:B[1],soft:B[1]}},J=!1),!J&&$a(B))){let rt=B;B=(dt,vt,Pt)=>vt==null?Uo:Aa(vt,Pt,rt)}y.range=le(B||(N?m_:v==P?y.distr==3?__:y.distr==4?v_:Hp:y.distr==3?Vp:y.distr==4?Gp:g_)),y.auto=le(J?!1:y.auto),y.clamp=le(y.clamp||e_),y._min=y._max=null,y.valToPct=E(y)}}}b("x"),b("y"),s==1&&M.forEach(v=>{b(v.scale)}),S.forEach(v=>{b(v.scale)});for(let v in i.scales)b(v);const R=x[P],H=R.distr;let O,q;R.ori==0?(On(c,Rg),O=o,q=r):(On(c,Cg),O=r,q=o);const $={};for(let v in x){let y=x[v];(y.min!=null||y.max!=null)&&($[v]={min:y.min,max:y.max},y.min=y.max=null)}const X=i.tzDate||(v=>new Date(Je(v/f))),j=i.fmtDate||Eh,Q=f==1?R0(X):L0(X),at=Yu(X,ju(f==1?A0:P0,j)),lt=Zu(X,Ku(I0,j)),gt=[],xt=n.legend=je({},k0,i.legend),mt=n.cursor=je({},V0,{drag:{y:s==2}},i.cursor),ot=xt.show,ut=mt.show,_t=xt.markers;xt.idxs=gt,_t.width=le(_t.width),_t.dash=le(_t.dash),_t.stroke=le(_t.stroke),_t.fill=le(_t.fill);let ht,Nt,zt,Ut=[],ce=[],Jt,he=!1,G={};if(xt.live){const v=M[1]?M[1].values:null;he=v!=null,Jt=he?v(n,1,0):{_:0};for(let y in Jt)G[y]=xh}if(ot)if(ht=ei("table",Bg,c),zt=ei("tbody",null,ht),xt.mount(n,ht),he){Nt=ei("thead",null,ht,zt);let v=ei("tr",null,Nt);ei("th",null,v);for(var Ke in Jt)ei("th",Eu,v).textContent=Ke}else On(ht,Hg),xt.live&&On(ht,zg);const te={show:!0},ie={show:!1};function Wt(v,y){if(y==0&&(he||!xt.live||s==2))return Uo;let L=[],N=ei("tr",Vg,zt,zt.childNodes[y]);On(N,v.class),v.show||On(N,Is);let B=ei("th",null,N);if(_t.show){let dt=qn(Gg,B);if(y>0){let vt=_t.width(n,y);vt&&(dt.style.border=vt+"px "+_t.dash(n,y)+" "+_t.stroke(n,y)),dt.style.background=_t.fill(n,y)}}let J=qn(Eu,B);v.label instanceof HTMLElement?J.appendChild(v.label):J.textContent=v.label,y>0&&(_t.show||(J.style.color=v.width>0?_t.stroke(n,y):_t.fill(n,y)),Dt("click",B,dt=>{if(mt._lock)return;Ze(dt);let vt=M.indexOf(v);if((dt.ctrlKey||dt.metaKey)!=xt.isolate){let Pt=M.some((Lt,It)=>It>0&&It!=vt&&Lt.show);M.forEach((Lt,It)=>{It>0&&fi(It,Pt?It==vt?te:ie:te,!0,qe.setSeries)})}else fi(vt,{show:!v.show},!0,qe.setSeries)},!1),Ei&&Dt(Cu,B,dt=>{mt._lock||(Ze(dt),fi(M.indexOf(v),ro,!0,qe.setSeries))},!1));for(var rt in Jt){let dt=ei("td",Wg,N);dt.textContent="--",L.push(dt)}return[N,L]}const me=new Map;function Dt(v,y,L,N=!0){const B=me.get(y)||{},J=mt.bind[v](n,y,L,N);J&&(Bs(v,y,B[v]=J),me.set(y,B))}function D(v,y,L){const N=me.get(y)||{};for(let B in N)(v==null||B==v)&&(uc(B,y,N[B]),delete N[B]);v==null&&me.delete(y)}let w=0,tt=0,nt=0,Y=0,it=0,St=0,bt=it,At=St,Zt=nt,pt=Y,yt=0,Ot=0,Ht=0,Et=0;n.bbox={};let oe=!1,Yt=!1,ge=!1,V=!1,Mt=!1,st=!1;function ct(v,y,L){(L||v!=n.width||y!=n.height)&&Rt(v,y),Qs(!1),ge=!0,Yt=!0,to()}function Rt(v,y){n.width=w=nt=v,n.height=tt=Y=y,it=St=0,sn(),Me();let L=n.bbox;yt=L.left=Ps(it*we,.5),Ot=L.top=Ps(St*we,.5),Ht=L.width=Ps(nt*we,.5),Et=L.height=Ps(Y*we,.5)}const Ct=3;function Qt(){let v=!1,y=0;for(;!v;){y++;let L=hg(y),N=ug(y);v=y==Ct||L&&N,v||(Rt(n.width,n.height),Yt=!0)}}function Oe({width:v,height:y}){ct(v,y)}n.setSize=Oe;function sn(){let v=!1,y=!1,L=!1,N=!1;S.forEach((B,J)=>{if(B.show&&B._show){let{side:rt,_size:dt}=B,vt=rt%2,Pt=B.label!=null?B.labelSize:0,Lt=dt+Pt;Lt>0&&(vt?(nt-=Lt,rt==3?(it+=Lt,N=!0):L=!0):(Y-=Lt,rt==0?(St+=Lt,v=!0):y=!0))}}),hi[0]=v,hi[1]=L,hi[2]=y,hi[3]=N,nt-=T[1]+T[3],it+=T[3],Y-=T[2]+T[0],St+=T[0]}function Me(){let v=it+nt,y=St+Y,L=it,N=St;function B(J,rt){switch(J){case 1:return v+=rt,v-rt;case 2:return y+=rt,y-rt;case 3:return L-=rt,L+rt;case 0:return N-=rt,N+rt}}S.forEach((J,rt)=>{if(J.show&&J._show){let dt=J.side;J._pos=B(dt,J._size),J.label!=null&&(J._lpos=B(dt,J.labelSize))}})}if(mt.dataIdx==null){let v=mt.hover,y=v.skip=new Set(v.skip??[]);y.add(void 0);let L=v.prox=le(v.prox),N=v.bias??=0;mt.dataIdx=(B,J,rt,dt)=>{if(J==0)return rt;let vt=rt,Pt=L(B,J,rt,dt)??Le,Lt=Pt>=0&&Pt<Le,It=R.ori==0?nt:Y,Kt=mt.left,Se=t[0],be=t[J];if(y.has(be[rt])){vt=null;let re=null,qt=null,Gt;if(N==0||N==-1)for(Gt=rt;re==null&&Gt-- >0;)y.has(be[Gt])||(re=Gt);if(N==0||N==1)for(Gt=rt;qt==null&&Gt++<be.length;)y.has(be[Gt])||(qt=Gt);if(re!=null||qt!=null)if(Lt){let ke=re==null?-1/0:O(Se[re],R,It,0),Ge=qt==null?1/0:O(Se[qt],R,It,0),cn=Kt-ke,Re=Ge-Kt;cn<=Re?cn<=Pt&&(vt=re):Re<=Pt&&(vt=qt)}else vt=qt==null?re:re==null?qt:rt-re<=qt-rt?re:qt}else Lt&&tn(Kt-O(Se[rt],R,It,0))>Pt&&(vt=null);return vt}}const Ze=v=>{mt.event=v};mt.idxs=gt,mt._lock=!1;let Ie=mt.points;Ie.show=le(Ie.show),Ie.size=le(Ie.size),Ie.stroke=le(Ie.stroke),Ie.width=le(Ie.width),Ie.fill=le(Ie.fill);const Dn=n.focus=je({},i.focus||{alpha:.3},mt.focus),Ei=Dn.prox>=0,An=Ei&&Ie.one;let mn=[],Ti=[],Ai=[];function gs(v,y){let L=Ie.show(n,y);if(L instanceof HTMLElement)return On(L,Og),On(L,v.class),_i(L,-10,-10,nt,Y),_.insertBefore(L,mn[y]),L}function tr(v,y){if(s==1||y>0){let L=s==1&&x[v.scale].time,N=v.value;v.value=L?Wu(N)?Zu(X,Ku(N,j)):N||lt:N||J0,v.label=v.label||(L?W0:G0)}if(An||y>0){v.width=v.width==null?1:v.width,v.paths=v.paths||d_||n0,v.fillTo=le(v.fillTo||i_),v.pxAlign=+ye(v.pxAlign,g),v.pxRound=rd(v.pxAlign),v.stroke=le(v.stroke||null),v.fill=le(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let L=Q0(En(1,v.width),1),N=v.points=je({},{size:L,width:En(1,L*.2),stroke:v.stroke,space:L*2,paths:f_,_stroke:null,_fill:null},v.points);N.show=le(N.show),N.filter=le(N.filter),N.fill=le(N.fill),N.stroke=le(N.stroke),N.paths=le(N.paths),N.pxAlign=v.pxAlign}if(ot){let L=Wt(v,y);Ut.splice(y,0,L[0]),ce.splice(y,0,L[1]),xt.values.push(null)}if(ut){gt.splice(y,0,null);let L=null;An?y==0&&(L=gs(v,y)):y>0&&(L=gs(v,y)),mn.splice(y,0,L),Ti.splice(y,0,0),Ai.splice(y,0,0)}ln("addSeries",y)}function Zs(v,y){y=y??M.length,v=s==1?_c(v,y,Qu,sd):_c(v,y,{},id),M.splice(y,0,v),tr(M[y],y)}n.addSeries=Zs;function Lr(v){if(M.splice(v,1),ot){xt.values.splice(v,1),ce.splice(v,1);let y=Ut.splice(v,1)[0];D(null,y.firstChild),y.remove()}ut&&(gt.splice(v,1),mn.splice(v,1)[0].remove(),Ti.splice(v,1),Ai.splice(v,1)),ln("delSeries",v)}n.delSeries=Lr;const hi=[!1,!1,!1,!1];function il(v,y){if(v._show=v.show,v.show){let L=v.side%2,N=x[v.scale];N==null&&(v.scale=L?M[1].scale:P,N=x[v.scale]);let B=N.time;v.size=le(v.size),v.space=le(v.space),v.rotate=le(v.rotate),ns(v.incrs)&&v.incrs.forEach(rt=>{!cs.has(rt)&&cs.set(rt,dp(rt))}),v.incrs=le(v.incrs||(N.distr==2?w0:B?f==1?T0:C0:Ls)),v.splits=le(v.splits||(B&&N.distr==1?Q:N.distr==3?fc:N.distr==4?X0:q0)),v.stroke=le(v.stroke),v.grid.stroke=le(v.grid.stroke),v.ticks.stroke=le(v.ticks.stroke),v.border.stroke=le(v.border.stroke);let J=v.values;v.values=ns(J)&&!ns(J[0])?le(J):B?ns(J)?Yu(X,ju(J,j)):Wu(J)?D0(X,J):J||at:J||$0,v.filter=le(v.filter||(N.distr>=3&&N.log==10?K0:N.distr==3&&N.log==2?Z0:hp)),v.font=hd(v.font),v.labelFont=hd(v.labelFont),v._size=v.size(n,null,y,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(hi[y]=!0,v._el=qn(Ng,d))}}function _s(v,y,L,N){let[B,J,rt,dt]=L,vt=y%2,Pt=0;return vt==0&&(dt||J)&&(Pt=y==0&&!B||y==2&&!rt?Je(Ju.size/3):0),vt==1&&(B||rt)&&(Pt=y==1&&!J||y==3&&!dt?Je(ed.size/2):0),Pt}const Dr=n.padding=(i.padding||[_s,_s,_s,_s]).map(v=>le(ye(v,_s))),T=n._padding=Dr.map((v,y)=>v(n,y,hi,0));let z,K=null,Z=null;const W=s==1?M[0].idxs:null;let ft=null,wt=!1;function Bt(v,y){if(t=v??[],n.data=n._data=t,s==2){z=0;for(let L=1;L<M.length;L++)z+=t[L][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ft=t[0],z=ft.length;let L=t;if(H==2){L=t.slice();let N=L[0]=Array(z);for(let B=0;B<z;B++)N[B]=B}n._data=t=L}if(Qs(!0),ln("setData"),H==2&&(ge=!0),y!==!1){let L=R;L.auto(n,wt)?kt():Xi(P,L.min,L.max),V=V||mt.left>=0,st=!0,to()}}n.setData=Bt;function kt(){wt=!0;let v,y;s==1&&(z>0?(K=W[0]=0,Z=W[1]=z-1,v=t[0][K],y=t[0][Z],H==2?(v=K,y=Z):v==y&&(H==3?[v,y]=Ga(v,v,R.log,!1):H==4?[v,y]=yh(v,v,R.log,!1):R.time?y=v+Je(86400/f):[v,y]=Aa(v,y,Mh,!0))):(K=W[0]=v=null,Z=W[1]=y=null)),Xi(P,v,y)}let $t,Xt,Ft,ae,Ee,Ae,on,ue,Vt,Be;function _e(v,y,L,N,B,J){v??=Au,L??=wh,N??="butt",B??=Au,J??="round",v!=$t&&(u.strokeStyle=$t=v),B!=Xt&&(u.fillStyle=Xt=B),y!=Ft&&(u.lineWidth=Ft=y),J!=Ee&&(u.lineJoin=Ee=J),N!=Ae&&(u.lineCap=Ae=N),L!=ae&&u.setLineDash(ae=L)}function Rn(v,y,L,N){y!=Xt&&(u.fillStyle=Xt=y),v!=on&&(u.font=on=v),L!=ue&&(u.textAlign=ue=L),N!=Vt&&(u.textBaseline=Vt=N)}function ui(v,y,L,N,B=0){if(N.length>0&&v.auto(n,wt)&&(y==null||y.min==null)){let J=ye(K,0),rt=ye(Z,N.length-1),dt=L.min==null?Kg(N,J,rt,B,v.distr==3):[L.min,L.max];v.min=oi(v.min,L.min=dt[0]),v.max=En(v.max,L.max=dt[1])}}const gn={min:null,max:null};function vs(){for(let N in x){let B=x[N];$[N]==null&&(B.min==null||$[P]!=null&&B.auto(n,wt))&&($[N]=gn)}for(let N in x){let B=x[N];$[N]==null&&B.from!=null&&$[B.from]!=null&&($[N]=gn)}$[P]!=null&&Qs(!0);let v={};for(let N in $){let B=$[N];if(B!=null){let J=v[N]=ko(x[N],o0);if(B.min!=null)je(J,B);else if(N!=P||s==2)if(z==0&&J.from==null){let rt=J.range(n,null,null,N);J.min=rt[0],J.max=rt[1]}else J.min=Le,J.max=-Le}}if(z>0){M.forEach((N,B)=>{if(s==1){let J=N.scale,rt=$[J];if(rt==null)return;let dt=v[J];if(B==0){let vt=dt.range(n,dt.min,dt.max,J);dt.min=vt[0],dt.max=vt[1],K=si(dt.min,t[0]),Z=si(dt.max,t[0]),Z-K>1&&(t[0][K]<dt.min&&K++,t[0][Z]>dt.max&&Z--),N.min=ft[K],N.max=ft[Z]}else N.show&&N.auto&&ui(dt,rt,N,t[B],N.sorted);N.idxs[0]=K,N.idxs[1]=Z}else if(B>0&&N.show&&N.auto){let[J,rt]=N.facets,dt=J.scale,vt=rt.scale,[Pt,Lt]=t[B],It=v[dt],Kt=v[vt];It!=null&&ui(It,$[dt],J,Pt,J.sorted),Kt!=null&&ui(Kt,$[vt],rt,Lt,rt.sorted),N.min=rt.min,N.max=rt.max}});for(let N in v){let B=v[N],J=$[N];if(B.from==null&&(J==null||J.min==null)){let rt=B.range(n,B.min==Le?null:B.min,B.max==-Le?null:B.max,N);B.min=rt[0],B.max=rt[1]}}}for(let N in v){let B=v[N];if(B.from!=null){let J=v[B.from];if(J.min==null)B.min=B.max=null;else{let rt=B.range(n,J.min,J.max,N);B.min=rt[0],B.max=rt[1]}}}let y={},L=!1;for(let N in v){let B=v[N],J=x[N];if(J.min!=B.min||J.max!=B.max){J.min=B.min,J.max=B.max;let rt=J.distr;J._min=rt==3?Bi(J.min):rt==4?vl(J.min,J.asinh):rt==100?J.fwd(J.min):J.min,J._max=rt==3?Bi(J.max):rt==4?vl(J.max,J.asinh):rt==100?J.fwd(J.max):J.max,y[N]=L=!0}}if(L){M.forEach((N,B)=>{s==2?B>0&&y.y&&(N._paths=null):y[N.scale]&&(N._paths=null)});for(let N in y)ge=!0,ln("setScale",N);ut&&mt.left>=0&&(V=st=!0)}for(let N in $)$[N]=null}function Pe(v){let y=dc(K-1,0,z-1),L=dc(Z+1,0,z-1);for(;v[y]==null&&y>0;)y--;for(;v[L]==null&&L<z-1;)L++;return[y,L]}function Vn(){if(z>0){let v=M.some(y=>y._focus)&&Be!=Dn.alpha;v&&(u.globalAlpha=Be=Dn.alpha),M.forEach((y,L)=>{if(L>0&&y.show&&($i(L,!1),$i(L,!0),y._paths==null)){let N=Be;Be!=y.alpha&&(u.globalAlpha=Be=y.alpha);let B=s==2?[0,t[L][0].length-1]:Pe(t[L]);y._paths=y.paths(n,L,B[0],B[1]),Be!=N&&(u.globalAlpha=Be=N)}}),M.forEach((y,L)=>{if(L>0&&y.show){let N=Be;Be!=y.alpha&&(u.globalAlpha=Be=y.alpha),y._paths!=null&&bn(L,!1);{let B=y._paths!=null?y._paths.gaps:null,J=y.points.show(n,L,K,Z,B),rt=y.points.filter(n,L,J,B);(J||rt)&&(y.points._paths=y.points.paths(n,L,K,Z,rt),bn(L,!0))}Be!=N&&(u.globalAlpha=Be=N),ln("drawSeries",L)}}),v&&(u.globalAlpha=Be=1)}}function $i(v,y){let L=y?M[v].points:M[v];L._stroke=L.stroke(n,v),L._fill=L.fill(n,v)}function bn(v,y){let L=y?M[v].points:M[v],{stroke:N,fill:B,clip:J,flags:rt,_stroke:dt=L._stroke,_fill:vt=L._fill,_width:Pt=L.width}=L._paths;Pt=De(Pt*we,3);let Lt=null,It=Pt%2/2;y&&vt==null&&(vt=Pt>0?"#fff":dt);let Kt=L.pxAlign==1&&It>0;if(Kt&&u.translate(It,It),!y){let Se=yt-Pt/2,be=Ot-Pt/2,re=Ht+Pt,qt=Et+Pt;Lt=new Path2D,Lt.rect(Se,be,re,qt)}y?Js(dt,Pt,L.dash,L.cap,vt,N,B,rt,J):di(v,dt,Pt,L.dash,L.cap,vt,N,B,rt,Lt,J),Kt&&u.translate(-It,-It)}function di(v,y,L,N,B,J,rt,dt,vt,Pt,Lt){let It=!1;vt!=0&&k.forEach((Kt,Se)=>{if(Kt.series[0]==v){let be=M[Kt.series[1]],re=t[Kt.series[1]],qt=(be._paths||yr).band;ns(qt)&&(qt=Kt.dir==1?qt[0]:qt[1]);let Gt,ke=null;be.show&&qt&&Jg(re,K,Z)?(ke=Kt.fill(n,Se)||J,Gt=be._paths.clip):qt=null,Js(y,L,N,B,ke,rt,dt,vt,Pt,Lt,Gt,qt),It=!0}}),It||Js(y,L,N,B,J,rt,dt,vt,Pt,Lt)}const Yn=Fo|mc;function Js(v,y,L,N,B,J,rt,dt,vt,Pt,Lt,It){_e(v,y,L,N,B),(vt||Pt||It)&&(u.save(),vt&&u.clip(vt),Pt&&u.clip(Pt)),It?(dt&Yn)==Yn?(u.clip(It),Lt&&u.clip(Lt),Nr(B,rt),Ir(v,J,y)):dt&mc?(Nr(B,rt),u.clip(It),Ir(v,J,y)):dt&Fo&&(u.save(),u.clip(It),Lt&&u.clip(Lt),Nr(B,rt),u.restore(),Ir(v,J,y)):(Nr(B,rt),Ir(v,J,y)),(vt||Pt||It)&&u.restore()}function Ir(v,y,L){L>0&&(y instanceof Map?y.forEach((N,B)=>{u.strokeStyle=$t=B,u.stroke(N)}):y!=null&&v&&u.stroke(y))}function Nr(v,y){y instanceof Map?y.forEach((L,N)=>{u.fillStyle=Xt=N,u.fill(L)}):y!=null&&v&&u.fill(y)}function cg(v,y,L,N){let B=S[v],J;if(N<=0)J=[0,0];else{let rt=B._space=B.space(n,v,y,L,N),dt=B._incrs=B.incrs(n,v,y,L,N,rt);J=x_(y,L,dt,N,rt)}return B._found=J}function sl(v,y,L,N,B,J,rt,dt,vt,Pt){let Lt=rt%2/2;g==1&&u.translate(Lt,Lt),_e(dt,rt,vt,Pt,dt),u.beginPath();let It,Kt,Se,be,re=B+(N==0||N==3?-J:J);L==0?(Kt=B,be=re):(It=B,Se=re);for(let qt=0;qt<v.length;qt++)y[qt]!=null&&(L==0?It=Se=v[qt]:Kt=be=v[qt],u.moveTo(It,Kt),u.lineTo(Se,be));u.stroke(),g==1&&u.translate(-Lt,-Lt)}function hg(v){let y=!0;return S.forEach((L,N)=>{if(!L.show)return;let B=x[L.scale];if(B.min==null){L._show&&(y=!1,L._show=!1,Qs(!1));return}else L._show||(y=!1,L._show=!0,Qs(!1));let J=L.side,rt=J%2,{min:dt,max:vt}=B,[Pt,Lt]=cg(N,dt,vt,rt==0?nt:Y);if(Lt==0)return;let It=B.distr==2,Kt=L._splits=L.splits(n,N,dt,vt,Pt,Lt,It),Se=B.distr==2?Kt.map(Gt=>ft[Gt]):Kt,be=B.distr==2?ft[Kt[1]]-ft[Kt[0]]:Pt,re=L._values=L.values(n,L.filter(n,Se,N,Lt,be),N,Lt,be);L._rotate=J==2?L.rotate(n,re,N,Lt):0;let qt=L._size;L._size=Xn(L.size(n,re,N,v)),qt!=null&&L._size!=qt&&(y=!1)}),y}function ug(v){let y=!0;return Dr.forEach((L,N)=>{let B=L(n,N,hi,v);B!=T[N]&&(y=!1),T[N]=B}),y}function dg(){for(let v=0;v<S.length;v++){let y=S[v];if(!y.show||!y._show)continue;let L=y.side,N=L%2,B,J,rt=y.stroke(n,v),dt=L==0||L==3?-1:1,[vt,Pt]=y._found;if(y.label!=null){let Mn=y.labelGap*dt,Un=Je((y._lpos+Mn)*we);Rn(y.labelFont[0],rt,"center",L==2?"top":Tu),u.save(),N==1?(B=J=0,u.translate(Un,Je(Ot+Et/2)),u.rotate((L==3?-ga:ga)/2)):(B=Je(yt+Ht/2),J=Un);let ys=lp(y.label)?y.label(n,v,vt,Pt):y.label;u.fillText(ys,B,J),u.restore()}if(Pt==0)continue;let Lt=x[y.scale],It=N==0?Ht:Et,Kt=N==0?yt:Ot,Se=y._splits,be=Lt.distr==2?Se.map(Mn=>ft[Mn]):Se,re=Lt.distr==2?ft[Se[1]]-ft[Se[0]]:vt,qt=y.ticks,Gt=y.border,ke=qt.show?qt.size:0,Ge=Je(ke*we),cn=Je((y.alignTo==2?y._size-ke-y.gap:y.gap)*we),Re=y._rotate*-ga/180,We=m(y._pos*we),In=(Ge+cn)*dt,yn=We+In;J=N==0?yn:0,B=N==1?yn:0;let Gn=y.font[0],Kn=y.align==1?lo:y.align==2?ml:Re>0?lo:Re<0?ml:N==0?"center":L==3?ml:lo,mi=Re||N==1?"middle":L==2?"top":Tu;Rn(Gn,rt,Kn,mi);let Nn=y.font[1]*y.lineGap,Wn=Se.map(Mn=>m(a(Mn,Lt,It,Kt))),Zn=y._values;for(let Mn=0;Mn<Zn.length;Mn++){let Un=Zn[Mn];if(Un!=null){N==0?B=Wn[Mn]:J=Wn[Mn],Un=""+Un;let ys=Un.indexOf(`
`)==-1?[Un]:Un.split(/\n/gm);for(let Sn=0;Sn<ys.length;Sn++){let wu=ys[Sn];Re?(u.save(),u.translate(B,J+Sn*Nn),u.rotate(Re),u.fillText(wu,0,0),u.restore()):u.fillText(wu,B,J+Sn*Nn)}}}qt.show&&sl(Wn,qt.filter(n,be,v,Pt,re),N,L,We,Ge,De(qt.width*we,3),qt.stroke(n,v),qt.dash,qt.cap);let gi=y.grid;gi.show&&sl(Wn,gi.filter(n,be,v,Pt,re),N,N==0?2:1,N==0?Ot:yt,N==0?Et:Ht,De(gi.width*we,3),gi.stroke(n,v),gi.dash,gi.cap),Gt.show&&sl([We],[1],N==0?1:0,N==0?1:2,N==1?Ot:yt,N==1?Et:Ht,De(Gt.width*we,3),Gt.stroke(n,v),Gt.dash,Gt.cap)}ln("drawAxes")}function Qs(v){M.forEach((y,L)=>{L>0&&(y._paths=null,v&&(s==1?(y.min=null,y.max=null):y.facets.forEach(N=>{N.min=null,N.max=null})))})}let Ur=!1,ol=!1,er=[];function fg(){ol=!1;for(let v=0;v<er.length;v++)ln(...er[v]);er.length=0}function to(){Ur||(d0(ru),Ur=!0)}function pg(v,y=!1){Ur=!0,ol=y,v(n),ru(),y&&er.length>0&&queueMicrotask(fg)}n.batch=pg;function ru(){if(oe&&(vs(),oe=!1),ge&&(Qt(),ge=!1),Yt){if(Fe(p,lo,it),Fe(p,"top",St),Fe(p,pr,nt),Fe(p,mr,Y),Fe(_,lo,it),Fe(_,"top",St),Fe(_,pr,nt),Fe(_,mr,Y),Fe(d,pr,w),Fe(d,mr,tt),h.width=Je(w*we),h.height=Je(tt*we),S.forEach(({_el:v,_show:y,_size:L,_pos:N,side:B})=>{if(v!=null)if(y){let J=B===3||B===0?L:0,rt=B%2==1;Fe(v,rt?"left":"top",N-J),Fe(v,rt?"width":"height",L),Fe(v,rt?"top":"left",rt?St:it),Fe(v,rt?"height":"width",rt?Y:nt),hc(v,Is)}else On(v,Is)}),$t=Xt=Ft=Ee=Ae=on=ue=Vt=ae=null,Be=1,sr(!0),it!=bt||St!=At||nt!=Zt||Y!=pt){Qs(!1);let v=nt/Zt,y=Y/pt;if(ut&&!V&&mt.left>=0){mt.left*=v,mt.top*=y,eo&&_i(eo,Je(mt.left),0,nt,Y),no&&_i(no,0,Je(mt.top),nt,Y);for(let L=0;L<mn.length;L++){let N=mn[L];N!=null&&(Ti[L]*=v,Ai[L]*=y,_i(N,Xn(Ti[L]),Xn(Ai[L]),nt,Y))}}if(Ue.show&&!Mt&&Ue.left>=0&&Ue.width>0){Ue.left*=v,Ue.width*=v,Ue.top*=y,Ue.height*=y;for(let L in ul)Fe(oo,L,Ue[L])}bt=it,At=St,Zt=nt,pt=Y}ln("setSize"),Yt=!1}w>0&&tt>0&&(u.clearRect(0,0,h.width,h.height),ln("drawClear"),I.forEach(v=>v()),ln("draw")),Ue.show&&Mt&&(kr(Ue),Mt=!1),ut&&V&&(bs(null,!0,!1),V=!1),xt.show&&xt.live&&st&&(cl(),st=!1),l||(l=!0,n.status=1,ln("ready")),wt=!1,Ur=!1}n.redraw=(v,y)=>{ge=y||!1,v!==!1?Xi(P,R.min,R.max):to()};function rl(v,y){let L=x[v];if(L.from==null){if(z==0){let N=L.range(n,y.min,y.max,v);y.min=N[0],y.max=N[1]}if(y.min>y.max){let N=y.min;y.min=y.max,y.max=N}if(z>1&&y.min!=null&&y.max!=null&&y.max-y.min<1e-16)return;v==P&&L.distr==2&&z>0&&(y.min=si(y.min,t[0]),y.max=si(y.max,t[0]),y.min==y.max&&y.max++),$[v]=y,oe=!0,to()}}n.setScale=rl;let al,ll,eo,no,au,lu,io,so,cu,hu,Ne,ze,qi=!1;const dn=mt.drag;let rn=dn.x,an=dn.y;ut&&(mt.x&&(al=qn(kg,_)),mt.y&&(ll=qn(Fg,_)),R.ori==0?(eo=al,no=ll):(eo=ll,no=al),Ne=mt.left,ze=mt.top);const Ue=n.select=je({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),oo=Ue.show?qn(Ug,Ue.over?_:p):null;function kr(v,y){if(Ue.show){for(let L in v)Ue[L]=v[L],L in ul&&Fe(oo,L,v[L]);y!==!1&&ln("setSelect")}}n.setSelect=kr;function mg(v){if(M[v].show)ot&&hc(Ut[v],Is);else if(ot&&On(Ut[v],Is),ut){let L=An?mn[0]:mn[v];L!=null&&_i(L,-10,-10,nt,Y)}}function Xi(v,y,L){rl(v,{min:y,max:L})}function fi(v,y,L,N){y.focus!=null&&bg(v),y.show!=null&&M.forEach((B,J)=>{J>0&&(v==J||v==null)&&(B.show=y.show,mg(J),s==2?(Xi(B.facets[0].scale,null,null),Xi(B.facets[1].scale,null,null)):Xi(B.scale,null,null),to())}),L!==!1&&ln("setSeries",v,y),N&&or("setSeries",n,v,y)}n.setSeries=fi;function gg(v,y){je(k[v],y)}function _g(v,y){v.fill=le(v.fill||null),v.dir=ye(v.dir,-1),y=y??k.length,k.splice(y,0,v)}function vg(v){v==null?k.length=0:k.splice(v,1)}n.addBand=_g,n.setBand=gg,n.delBand=vg;function xg(v,y){M[v].alpha=y,ut&&mn[v]!=null&&(mn[v].style.opacity=y),ot&&Ut[v]&&(Ut[v].style.opacity=y)}let Ri,ji,xs;const ro={focus:!0};function bg(v){if(v!=xs){let y=v==null,L=Dn.alpha!=1;M.forEach((N,B)=>{if(s==1||B>0){let J=y||B==0||B==v;N._focus=y?null:J,L&&xg(B,J?1:Dn.alpha)}}),xs=v,L&&to()}}ot&&Ei&&Dt(Pu,ht,v=>{mt._lock||(Ze(v),xs!=null&&fi(null,ro,!0,qe.setSeries))});function pi(v,y,L){let N=x[y];L&&(v=v/we-(N.ori==1?St:it));let B=nt;N.ori==1&&(B=Y,v=B-v),N.dir==-1&&(v=B-v);let J=N._min,rt=N._max,dt=v/B,vt=J+(rt-J)*dt,Pt=N.distr;return Pt==3?No(10,vt):Pt==4?t0(vt,N.asinh):Pt==100?N.bwd(vt):vt}function yg(v,y){let L=pi(v,P,y);return si(L,t[0],K,Z)}n.valToIdx=v=>si(v,t[0]),n.posToIdx=yg,n.posToVal=pi,n.valToPos=(v,y,L)=>x[y].ori==0?o(v,x[y],L?Ht:nt,L?yt:0):r(v,x[y],L?Et:Y,L?Ot:0),n.setCursor=(v,y,L)=>{Ne=v.left,ze=v.top,bs(null,y,L)};function uu(v,y){Fe(oo,lo,Ue.left=v),Fe(oo,pr,Ue.width=y)}function du(v,y){Fe(oo,"top",Ue.top=v),Fe(oo,mr,Ue.height=y)}let nr=R.ori==0?uu:du,ir=R.ori==1?uu:du;function Mg(){if(ot&&xt.live)for(let v=s==2?1:0;v<M.length;v++){if(v==0&&he)continue;let y=xt.values[v],L=0;for(let N in y)ce[v][L++].firstChild.nodeValue=y[N]}}function cl(v,y){if(v!=null&&(v.idxs?v.idxs.forEach((L,N)=>{gt[N]=L}):s0(v.idx)||gt.fill(v.idx),xt.idx=gt[0]),ot&&xt.live){for(let L=0;L<M.length;L++)(L>0||s==1&&!he)&&Sg(L,gt[L]);Mg()}st=!1,y!==!1&&ln("setLegend")}n.setLegend=cl;function Sg(v,y){let L=M[v],N=v==0&&H==2?ft:t[v],B;he?B=L.values(n,v,y)??G:(B=L.value(n,y==null?null:N[y],v,y),B=B==null?G:{_:B}),xt.values[v]=B}function bs(v,y,L){cu=Ne,hu=ze,[Ne,ze]=mt.move(n,Ne,ze),mt.left=Ne,mt.top=ze,ut&&(eo&&_i(eo,Je(Ne),0,nt,Y),no&&_i(no,0,Je(ze),nt,Y));let N,B=K>Z;Ri=Le,ji=null;let J=R.ori==0?nt:Y,rt=R.ori==1?nt:Y;if(Ne<0||z==0||B){N=mt.idx=null;for(let dt=0;dt<M.length;dt++){let vt=mn[dt];vt!=null&&_i(vt,-10,-10,nt,Y)}Ei&&fi(null,ro,!0,v==null&&qe.setSeries),xt.live&&(gt.fill(N),st=!0)}else{let dt,vt,Pt;s==1&&(dt=R.ori==0?Ne:ze,vt=pi(dt,P),N=mt.idx=si(vt,t[0],K,Z),Pt=O(t[0][N],R,J,0));let Lt=-10,It=-10,Kt=0,Se=0,be=!0,re="",qt="";for(let Gt=s==2?1:0;Gt<M.length;Gt++){let ke=M[Gt],Ge=gt[Gt],cn=Ge==null?null:s==1?t[Gt][Ge]:t[Gt][1][Ge],Re=mt.dataIdx(n,Gt,N,vt),We=Re==null?null:s==1?t[Gt][Re]:t[Gt][1][Re];if(st=st||We!=cn||Re!=Ge,gt[Gt]=Re,Gt>0&&ke.show){let In=Re==null?-10:Re==N?Pt:O(s==1?t[0][Re]:t[Gt][0][Re],R,J,0),yn=We==null?-10:q(We,s==1?x[ke.scale]:x[ke.facets[1].scale],rt,0);if(Ei&&We!=null){let Gn=R.ori==1?Ne:ze,Kn=tn(Dn.dist(n,Gt,Re,yn,Gn));if(Kn<Ri){let mi=Dn.bias;if(mi!=0){let Nn=pi(Gn,ke.scale),Wn=We>=0?1:-1,Zn=Nn>=0?1:-1;Zn==Wn&&(Zn==1?mi==1?We>=Nn:We<=Nn:mi==1?We<=Nn:We>=Nn)&&(Ri=Kn,ji=Gt)}else Ri=Kn,ji=Gt}}if(st||An){let Gn,Kn;R.ori==0?(Gn=In,Kn=yn):(Gn=yn,Kn=In);let mi,Nn,Wn,Zn,gi,Mn,Un=!0,ys=Ie.bbox;if(ys!=null){Un=!1;let Sn=ys(n,Gt);Wn=Sn.left,Zn=Sn.top,mi=Sn.width,Nn=Sn.height}else Wn=Gn,Zn=Kn,mi=Nn=Ie.size(n,Gt);if(Mn=Ie.fill(n,Gt),gi=Ie.stroke(n,Gt),An)Gt==ji&&Ri<=Dn.prox&&(Lt=Wn,It=Zn,Kt=mi,Se=Nn,be=Un,re=Mn,qt=gi);else{let Sn=mn[Gt];Sn!=null&&(Ti[Gt]=Wn,Ai[Gt]=Zn,Fu(Sn,mi,Nn,Un),Uu(Sn,Mn,gi),_i(Sn,Xn(Wn),Xn(Zn),nt,Y))}}}}if(An){let Gt=Dn.prox,ke=xs==null?Ri<=Gt:Ri>Gt||ji!=xs;if(st||ke){let Ge=mn[0];Ge!=null&&(Ti[0]=Lt,Ai[0]=It,Fu(Ge,Kt,Se,be),Uu(Ge,re,qt),_i(Ge,Xn(Lt),Xn(It),nt,Y))}}}if(Ue.show&&qi)if(v!=null){let[dt,vt]=qe.scales,[Pt,Lt]=qe.match,[It,Kt]=v.cursor.sync.scales,Se=v.cursor.drag;if(rn=Se._x,an=Se._y,rn||an){let{left:be,top:re,width:qt,height:Gt}=v.select,ke=v.scales[It].ori,Ge=v.posToVal,cn,Re,We,In,yn,Gn=dt!=null&&Pt(dt,It),Kn=vt!=null&&Lt(vt,Kt);Gn&&rn?(ke==0?(cn=be,Re=qt):(cn=re,Re=Gt),We=x[dt],In=O(Ge(cn,It),We,J,0),yn=O(Ge(cn+Re,It),We,J,0),nr(oi(In,yn),tn(yn-In))):nr(0,J),Kn&&an?(ke==1?(cn=be,Re=qt):(cn=re,Re=Gt),We=x[vt],In=q(Ge(cn,Kt),We,rt,0),yn=q(Ge(cn+Re,Kt),We,rt,0),ir(oi(In,yn),tn(yn-In))):ir(0,rt)}else dl()}else{let dt=tn(cu-au),vt=tn(hu-lu);if(R.ori==1){let Kt=dt;dt=vt,vt=Kt}rn=dn.x&&dt>=dn.dist,an=dn.y&&vt>=dn.dist;let Pt=dn.uni;Pt!=null?rn&&an&&(rn=dt>=Pt,an=vt>=Pt,!rn&&!an&&(vt>dt?an=!0:rn=!0)):dn.x&&dn.y&&(rn||an)&&(rn=an=!0);let Lt,It;rn&&(R.ori==0?(Lt=io,It=Ne):(Lt=so,It=ze),nr(oi(Lt,It),tn(It-Lt)),an||ir(0,rt)),an&&(R.ori==1?(Lt=io,It=Ne):(Lt=so,It=ze),ir(oi(Lt,It),tn(It-Lt)),rn||nr(0,J)),!rn&&!an&&(nr(0,0),ir(0,0))}if(dn._x=rn,dn._y=an,v==null){if(L){if(Su!=null){let[dt,vt]=qe.scales;qe.values[0]=dt!=null?pi(R.ori==0?Ne:ze,dt):null,qe.values[1]=vt!=null?pi(R.ori==1?Ne:ze,vt):null}or(gl,n,Ne,ze,nt,Y,N)}if(Ei){let dt=L&&qe.setSeries,vt=Dn.prox;xs==null?Ri<=vt&&fi(ji,ro,!0,dt):Ri>vt?fi(null,ro,!0,dt):ji!=xs&&fi(ji,ro,!0,dt)}}st&&(xt.idx=N,cl()),y!==!1&&ln("setCursor")}let Yi=null;Object.defineProperty(n,"rect",{get(){return Yi==null&&sr(!1),Yi}});function sr(v=!1){v?Yi=null:(Yi=_.getBoundingClientRect(),ln("syncRect",Yi))}function fu(v,y,L,N,B,J,rt){mt._lock||qi&&v!=null&&v.movementX==0&&v.movementY==0||(hl(v,y,L,N,B,J,rt,!1,v!=null),v!=null?bs(null,!0,!0):bs(y,!0,!1))}function hl(v,y,L,N,B,J,rt,dt,vt){if(Yi==null&&sr(!1),Ze(v),v!=null)L=v.clientX-Yi.left,N=v.clientY-Yi.top;else{if(L<0||N<0){Ne=-10,ze=-10;return}let[Pt,Lt]=qe.scales,It=y.cursor.sync,[Kt,Se]=It.values,[be,re]=It.scales,[qt,Gt]=qe.match,ke=y.axes[0].side%2==1,Ge=R.ori==0?nt:Y,cn=R.ori==1?nt:Y,Re=ke?J:B,We=ke?B:J,In=ke?N:L,yn=ke?L:N;if(be!=null?L=qt(Pt,be)?a(Kt,x[Pt],Ge,0):-10:L=Ge*(In/Re),re!=null?N=Gt(Lt,re)?a(Se,x[Lt],cn,0):-10:N=cn*(yn/We),R.ori==1){let Gn=L;L=N,N=Gn}}vt&&(y==null||y.cursor.event.type==gl)&&((L<=1||L>=nt-1)&&(L=Ps(L,nt)),(N<=1||N>=Y-1)&&(N=Ps(N,Y))),dt?(au=L,lu=N,[io,so]=mt.move(n,L,N)):(Ne=L,ze=N)}const ul={width:0,height:0,left:0,top:0};function dl(){kr(ul,!1)}let pu,mu,gu,_u;function vu(v,y,L,N,B,J,rt){qi=!0,rn=an=dn._x=dn._y=!1,hl(v,y,L,N,B,J,rt,!0,!1),v!=null&&(Dt(_l,lc,xu,!1),or(Ru,n,io,so,nt,Y,null));let{left:dt,top:vt,width:Pt,height:Lt}=Ue;pu=dt,mu=vt,gu=Pt,_u=Lt}function xu(v,y,L,N,B,J,rt){qi=dn._x=dn._y=!1,hl(v,y,L,N,B,J,rt,!1,!0);let{left:dt,top:vt,width:Pt,height:Lt}=Ue,It=Pt>0||Lt>0,Kt=pu!=dt||mu!=vt||gu!=Pt||_u!=Lt;if(It&&Kt&&kr(Ue),dn.setScale&&It&&Kt){let Se=dt,be=Pt,re=vt,qt=Lt;if(R.ori==1&&(Se=vt,be=Lt,re=dt,qt=Pt),rn&&Xi(P,pi(Se,P),pi(Se+be,P)),an)for(let Gt in x){let ke=x[Gt];Gt!=P&&ke.from==null&&ke.min!=Le&&Xi(Gt,pi(re+qt,Gt),pi(re,Gt))}dl()}else mt.lock&&(mt._lock=!mt._lock,bs(y,!0,v!=null));v!=null&&(D(_l,lc),or(_l,n,Ne,ze,nt,Y,null))}function wg(v,y,L,N,B,J,rt){if(mt._lock)return;Ze(v);let dt=qi;if(qi){let vt=!0,Pt=!0,Lt=10,It,Kt;R.ori==0?(It=rn,Kt=an):(It=an,Kt=rn),It&&Kt&&(vt=Ne<=Lt||Ne>=nt-Lt,Pt=ze<=Lt||ze>=Y-Lt),It&&vt&&(Ne=Ne<io?0:nt),Kt&&Pt&&(ze=ze<so?0:Y),bs(null,!0,!0),qi=!1}Ne=-10,ze=-10,gt.fill(null),bs(null,!0,!0),dt&&(qi=dt)}function bu(v,y,L,N,B,J,rt){mt._lock||(Ze(v),kt(),dl(),v!=null&&or(Lu,n,Ne,ze,nt,Y,null))}function yu(){S.forEach(b_),ct(n.width,n.height,!0)}Bs(Ta,Po,yu);const ao={};ao.mousedown=vu,ao.mousemove=fu,ao.mouseup=xu,ao.dblclick=bu,ao.setSeries=(v,y,L,N)=>{let B=qe.match[2];L=B(n,y,L),L!=-1&&fi(L,N,!0,!1)},ut&&(Dt(Ru,_,vu),Dt(gl,_,fu),Dt(Cu,_,v=>{Ze(v),sr(!1)}),Dt(Pu,_,wg),Dt(Lu,_,bu),gc.add(n),n.syncRect=sr);const Fr=n.hooks=i.hooks||{};function ln(v,y,L){ol?er.push([v,y,L]):v in Fr&&Fr[v].forEach(N=>{N.call(null,n,y,L)})}(i.plugins||[]).forEach(v=>{for(let y in v.hooks)Fr[y]=(Fr[y]||[]).concat(v.hooks[y])});const Mu=(v,y,L)=>L,qe=je({key:null,setSeries:!1,filters:{pub:Vu,sub:Vu},scales:[P,M[1]?M[1].scale:null],match:[Gu,Gu,Mu],values:[null,null]},mt.sync);qe.match.length==2&&qe.match.push(Mu),mt.sync=qe;const Su=qe.key,fl=Dp(Su);function or(v,y,L,N,B,J,rt){qe.filters.pub(v,y,L,N,B,J,rt)&&fl.pub(v,y,L,N,B,J,rt)}fl.sub(n);function Eg(v,y,L,N,B,J,rt){qe.filters.sub(v,y,L,N,B,J,rt)&&ao[v](null,y,L,N,B,J,rt)}n.pub=Eg;function Tg(){fl.unsub(n),gc.delete(n),me.clear(),uc(Ta,Po,yu),c.remove(),ht?.remove(),ln("destroy")}n.destroy=Tg;function pl(){ln("init",i,t),Bt(t||i.data,!1),$[P]?rl(P,$[P]):kt(),Mt=Ue.show&&(Ue.width>0||Ue.height>0),V=st=!0,ct(i.width,i.height)}return M.forEach(tr),S.forEach(il),e?e instanceof HTMLElement?(e.appendChild(c),pl()):e(n,pl):pl(),n}xn.assign=je;xn.fmtNum=Sh;xn.rangeNum=Aa;xn.rangeLog=Ga;xn.rangeAsinh=yh;xn.orient=Ys;xn.pxRatio=we;xn.join=u0;xn.fmtDate=Eh,xn.tzDate=M0;xn.sync=Dp;{xn.addGap=s_,xn.clipGaps=qa;let i=xn.paths={points:Op};i.linear=zp,i.stepped=a_,i.bars=l_,i.spline=h_}const y_="Hand in",M_="To hand in: press Stand up, push the robot, then Hand in within a minute, and change nothing else in between. It saves a file on this device: give it to your teacher.",S_="This robot's electronics are a file of their own: a hand-in of it cannot be run again.",w_="There is no run to hand in: press Stand up, push the robot, then hand in within a minute.",E_="Certify",T_="{job} stopped: {why}",A_="Results as CSV",R_="To join the class",C_="upright lab",P_="Skip to the controls",L_="Connecting …",D_="The simulation is starting …",I_="Live",N_="No connection; trying again",U_="The lab does not answer. This page goes on by itself once upright lab runs again.",k_="Recording",F_="This page has stopped",O_="Light or dark",B_="What the buttons, keys and mouse do",z_="Close",H_="The robot in its room. Drag its body to push it; drag the floor to change the view.",V_="{body} leans {pitch} degrees and has rolled {way} centimetres.",G_="{body} has fallen.",W_="twin",$_="nonlinear model",q_="linear model",X_="published model",j_="calibrated model",Y_="The robot as MuJoCo simulates it, with contact and friction: it stands for the hardware",K_="The full equations of motion of the model, without contact",Z_="The same model, linearised about upright: valid for small angles",J_="The model with the equations as they were published",Q_="The model with the parameters that Calibrate has found",tv="It balances by itself: drag it to push it",ev="More curves",nv="Fewer curves",iv="robot: {body}",sv="knock {size} N s",ov="held from the front",rv="held from behind",av="pulled left",lv="pulled right",cv="push {size} N s",hv="push",uv="stood up",dv="best knock {best} N s",fv="The largest single knock, or push by hand of at most half a second, that it has recovered from. A longer push holds the robot and does not count. Nor does one that comes before it has recovered from another.",pv="Push a robot on two wheels, and see what keeps it upright",mv="New here? Take the tour",gv="1000 robots, each a little different, are held, released and knocked in simulation: about half a minute.",_v="Searching for the parameters with which the model predicts the log best.",vv="Searching the log for faults of units, signs, time and sensors.",xv="It begins soon; jobs run one at a time.",bv="{seconds} s so far",yv="about {seconds} s left",Mv="{seconds} s so far, longer than expected",Sv="300 robots, each a little different, are pushed in simulation. This takes a few seconds.",wv="It fell.",Ev="Stand up",Tv="Tilt",Av="The robot stands up again, tilted by 6°, and is let go",Rv="Pause",Cv="Play",Pv="One step",Lv="While paused: goes on by one step of the controller, some thousandths of a second",Dv="Speed",Iv="Back in time",Nv="Time",Uv="It lies; press Stand up first.",kv="Pushes",Fv="Hold from the front",Ov="A force on the front that holds a lean of 5.7° for 3 s and is then released (the paper's first push)",Bv="Hold from behind",zv="A force on the back that holds a lean of −6.9° for 3 s and is then released (the paper's second push)",Hv="Knock",Vv="A short blow to the body, of the size beside it (K)",Gv="Pull left",Wv="Pull right",$v="Pull left, Pull right",qv="A pull at one wheel for 0.3 s, a quarter of the robot's weight: it turns",Xv="Size",jv="Force times time: 0.05 N s is what an apple of 100 g brings at half a metre per second",Yv="pitch",Kv="pitch rate",Zv="wheel angle",Jv="wheel rate",Qv="yaw",tx="yaw rate",ex="Traces of the last seconds",nx="Settings, views and files",ix="Controller",sx="Robot",ox="Kit",rx="See",ax="Identify",lx="Keep",cx="Tour",hx="Class",ux="Method",dx="LQG: Kalman filter with dead time",fx="LQR with a Kalman filter",px="LQI: LQG with an integral of the wheel angle",mx="PID cascade",gx="H∞",_x="MPC: predictive, keeps limits",vx="Sliding mode",xx="Robust: one gain for many robots",bx="Gains by hand: u = −K x",yx="No controller",Mx="There is no controller, so there is no loop.",Sx="Largest accepted deviations (Bryson's rule): smaller means stricter",wx="command",Ex="Back to the default weights",Tx="This method has no weights to set here.",Ax="The weights of this controller were fixed when it was designed. To change something here, choose Gains by hand. In the live lab (upright lab, with Python) you can set them.",Rx="The new controller drives now: push the robot.",Cx="There is no certificate in this page. The live lab computes one for gains by hand, too: upright lab.",Px="Each change here designs the controller anew, for the kit as it is then. So a longer dead time that is known does less harm.",Lx="waits for the job in Identify",Dx="This run carried {mass} g that the robot's file does not have. Set Payload to 0 under Robot, push and drive for half a minute, then calibrate again.",Ix="Designing …",Nx="A robust design takes some ten seconds, longer on a busy machine. Until then another controller drives.",Ux="Gain K on the left motor",kx="u = −K x, in {unit} per rad and rad/s. ψ pitch, θ wheel angle, φ yaw; a dot marks their rates.",Fx="Saved; to save again:",Ox="Link copied. It opens this page on this computer; for others, put the page on a web host.",Bx="lean {size}°",zx="Link copied. It opens on this computer. For others, start the lab with upright lab --class.",Hx="The comparison is ready: it stands in the tab Identify.",Vx="Comparison ready:",Gx="Save {name}",Wx="Open",$x="{what}: large or small",qx="Fewer",Xx="More",jx="sets off by itself",Yx="There is no certificate in this page: the tab Python has its command.",Kx="unlimited",Zx="Certificate",Jx="computing …",Qx="{n} of {all} runs …",tb="none",eb="This page has no robot '{name}'; it shows {shown}. It has: {all}.",nb="This page leaves parts of the link out: {parts}.",ib="This page has no controller '{name}' for this robot; it shows {shown}. It has: {all}.",sb="The full certificate is ready. It stands in the tab Identify, too.",ob="Full certificate",rb="Robot",ab="Open robot.toml",lb="Parameters",cb="The controller is designed for these parameters.",hb="Back to the preset's parameters",ub="Payload unknown to the controller",db="Height of the payload above the axle",fb="Slope of the floor",pb="Grip of the wheels, coefficient of friction (twin)",mb="Bodies to compare",gb="Electronics",_b="ideal: nothing between controller and motors",vb="Noise, rounding and bias of the sensors",xb="Dead time from sensor to motor",bb="Battery",yb="Dead zone of the motors",Mb="Back to the kit's values",Sb="Loop: margins, Bode, Nyquist, poles",wb="What to see",Eb="Bode plot of the loop broken at both motors",Tb="Nyquist plot",Ab="Closed-loop poles",Rb="Phase portrait",Cb="Voltage",Pb="Voltage at the left and right motor; bars mark saturation.",Lb="Torque of the left and right motor; bars mark saturation.",Db="Estimate",Ib="The controller's estimate of the pitch, and the true pitch.",Nb="This controller estimates no state: it reads the true state, or nothing.",Ub="Equations",kb="v in volts, or in the unit of the torque. Dry and rolling friction, slope and pushes are added to these.",Fb="truth",Ob="estimate",Bb="saturated",zb="Linearised about upright, ẋ = A x + B u",Hb="Open-loop poles",Vb="Log to use",Gb="this run (the last minute)",Wb="Open a log",$b="Doctor",qb="Finds faults of the log: units, signs, delays, bias …",Xb="Calibrate",jb="Estimates the robot's parameters from its raw sensors; the calibrated model is shown as a further trace",Yb="Compare",Kb="A page with numbers and figures of all bodies over the last minute, and of the opened log",Zb="Stop",Jb="Comparing …",Qb="Another job is still running; the comparison may take longer.",ty="Doctor: finds faults of the log. Calibrate: finds the robot's parameters in it; push and drive the robot for half a minute first, it then computes for some ten seconds to two minutes. Compare: a page of numbers and figures of all bodies.",ey="The files hold the run since the last change, at most the last minute.",ny="Data, for a spreadsheet or for upright",iy="Pages: numbers and figures, or the run to be seen again",sy="Files, for the commands of upright",oy="To show it: a picture, or a link to this set-up",ry="Log as CSV: what the curves show, at most the last minute, for a spreadsheet or for upright. Picture: the robot as you see it now.",ay="A report and a replay page need Python: the live lab (upright lab) makes them.",ly="Log as CSV",cy="Log as Parquet",hy="Report",uy="Replay page",dy="Controller file",fy="Robot file",py="Picture",my="Copy link",gy="Link copied. It restores this whole set-up.",_y="It carries no push.",vy="It repeats the last push.",xy="Your push by hand is in it as a knock of the same impulse.",by="Your push by hand was too long to be in it.",yy="{name} is ready",My="Recovered from a push of {impulse} N s; largest so far {best} N s",Sy="Recovered from a push of {impulse} N s, the largest so far",wy="It recovered, but not from a single push: no record.",Ey="It fell after a push of {impulse} N s.",Ty="It fell: several pushes, {impulse} N s in all, before it had recovered.",Ay="Reading {name}",Ry="force {force} N",Cy="Board",Py="Name",Ly="Largest push [N s]",Dy="Effort",Iy="Send my set-up to everyone",Ny="Your name",Uy="Type your name first.",ky="Join",Fy="Join the class",Oy="Step {n} of {all}",By="Do",zy="Watch",Hy="Think",Vy="Prepare",Gy="Next",Wy="Back to my robot",$y="Writing the file",qy="Previous",Xy=[["Mouse on the robot","drag and hold to push"],["Mouse on the floor","drag to change the view, scroll to zoom"],["One finger","on the robot: push it; beside it: change the view, sideways"],["← → ↑ ↓","turn and drive; a gamepad's left stick does the same"],["F, B","push from the front, from the back, while the key is held"],["K","knock"],["Space","pause and continue"],[".","one step"],[", and /","back and forth in time, while paused"],["S","stand up"],["1, 2, 3 …","open the first, second, third … tab"],["N, P","next and previous step of the tour; Enter sets it up"],["[ ] { } + −","change the view and zoom, while the room has the focus"],["?","this list"]],jy="Python",Yy="Linear model as a ghost beside the robot",Ky="Payload unknown to the controller: {mass} g, {height} cm above the axle",Zy="The controller stays as it was designed: for a level floor and the kit's own dead time.",Jy="Copy link",Qy="A link to this robot and controller, and to the last push; a short one by hand becomes a knock",tM="Link copied. Whoever opens it sees this robot and this controller.",eM="What follows needs upright, a program for Python 3.11 or newer. Whoever made this page has its folder: open a terminal in it, and type once:",nM="pip install .",iM="Copy",sM="Copied.",oM=[["A log of the twin of this robot, excited so that it can be calibrated from","upright example excited -o run.csv"],["A log of the twin of this robot, tilted, driven and turned so that it can be calibrated from","upright simulate -r {robot} -b twin -c lqg --start pitch=0.1 --drive {speed},start=1,until=4 --turn 1,start=2,until=5 -s 6 -o run.csv"],["Calibrate the robot from that log","upright calibrate run.csv --robot {robot}"],["Design this controller, with its margins, and save it","upright design {controller} -r {robot} -o controller.json"],["Certify this controller","upright certify {controller} -r {robot}"],["Your own robot, from a file, in a page like this","upright lab --export site --robots mine.toml"],["The live lab, with the MuJoCo twin, payloads, other electronics and every parameter","upright lab"]],rM=[{title:"Push it",do:"Press Knock. Or drag the robot with the mouse or a finger, and let go.",watch:"The wheels roll under the body, and its lean ψ comes back to zero. θ is the angle of the wheels. Before the first push it may stand still: the motors do not answer to small voltages. Or it sets off by itself, where the noise of the sensors passes this dead zone. Once it moves it goes on to sway a little, because of both.",ask:"How large a knock can it bear? The slider Size sets it. The robot is the twin, which MuJoCo simulates in place of the hardware; the pale ghosts are simpler models. Where do their curves differ in the second after the knock?",here:{watch:"The wheels roll under the body, and its lean ψ comes back to zero. θ is the angle of the wheels. Before the first push it may stand still: the motors do not answer to small voltages. Or it sets off by itself, where the noise of the sensors passes this dead zone. Once it moves it goes on to sway a little, because of both.",ask:"How large a knock can it bear? The slider Size sets it. The pale ghost beside the robot is a simpler, linear model: where does its curve differ in the second after the knock?"}},{title:"It falls by itself",do:"Press Prepare: nothing controls the robot then. It starts with a lean of 1.1°, in slow motion (× 1/10).",watch:"After the first tenth of a second ψ grows like an exponential, because one open-loop pole lies in the right half-plane. Its curve is shown up to 17° here.",ask:"How long does the lean take from 6° to 12°? Compare with ln 2 divided by the unstable pole (See, Equations). Why is the first doubling, from rest, slower?"},{title:"Linearise",do:"Press Prepare: only the two models start, without a controller, from a small lean. They fall in slow motion (× 1/10).",watch:"The pitch ψ of both models agrees almost down to the floor. The wheel angle θ separates halfway.",ask:"Which terms does the linear model approximate? Look at sin ψ and cos ψ. Why does θ show it before ψ?"},{title:"Regulate",do:"Press Prepare: an LQR balances it now. Tilt it. Then set the accepted pitch under Controller to about 2.3°, and tilt it again.",watch:"A smaller accepted pitch makes a larger gain on ψ. After a tilt the body leans less far, but comes back more slowly, and θ rolls further: its sensors do not show how far it was tilted.",ask:"How do the margins change when the accepted pitch gets smaller? If the whole state were known, a larger gain would bring it back more quickly: what is not known here?",here:{do:"Press Prepare: an LQR balances it now. Tilt it. Then choose Gains by hand under Controller. Move ψ pitch → u to about −50 and tilt it again, then to about −9.",watch:"At −50 θ rolls twice as far (460°, not 230°), and the largest gain factor that it bears falls from 1.29 to 1.12. At −9 the body swings several times. Tilted, it leans further at first, until its sensors show the lean.",ask:"How do the margins change with the gain on ψ? What do its sensors not know after a tilt?"}},{title:"Push the front",do:"Press Prepare: after a second a force on the front holds ψ near 5.7° for 3 s, and is then released.",watch:"The robot leans into the force, at first a little further, and rolls backwards. After the release ψ swings beyond zero, to about −1°, and the wheels return.",ask:"Why does a push on the front hold a forward lean? Think of the sum of moments."},{title:"Push the back",do:"Press Prepare: after a second a force from behind holds ψ near −6.9° for 3 s, and is then released.",watch:"The same response, mirrored. Its lean is a fifth larger, and θ at least so much: that differs from run to run. φ, under More curves, hardly moves.",ask:"Is the response exactly the mirror image? What would make the two sides differ?"},{title:"Compare",do:"Press Prepare: twin and models are held in the same way, and released. When they stand again, open Identify and press Compare.",watch:"All three agree. What is left is mostly noise: settling times jump by tenths of a second from run to run. Press Prepare again and compare.",ask:"The push is small: why is the linear model as good as the nonlinear one? Which signal shows the noise most?"},{title:"Break the linear model",do:"Press Prepare: the robot carries 200 g, 30 cm above its axle, that neither the controller nor the linear model includes. Knock it gently, then harder.",watch:"It may begin to sway by itself. After a gentle knock the linear ghost almost comes to rest, and the twin goes on to sway widely. At 0.3 N s the ghost falls, though it bore this knock in the first step. The knock hits at the centre of mass of the loaded robot. That is higher, so it turns the ghost, which has no payload, twice as fast.",ask:"Why does the loaded robot bear this knock from rest, but not always while it sways? How large a payload does it carry at most?",here:{do:"Press Prepare: the robot carries 300 g, 30 cm above its axle, that neither the controller nor the linear model includes. Knock it gently, then harder.",watch:"It may begin to sway by itself. After a gentle knock the linear ghost almost comes to rest, and the robot goes on to sway widely. At 0.3 N s the ghost falls, though it bore this knock in the first step. The knock hits at the centre of mass of the loaded robot. That is higher, so it turns the ghost, which has no payload, twice as fast.",ask:"Why does the loaded robot bear this knock from rest, but not always while it sways? Can gains by hand carry the payload?"}},{title:"Make it robust",do:"Press Prepare: a robust design has one gain for many robots. It takes some ten seconds. The payload stays on. Repeat your pushes.",watch:"The loaded robot sways as widely as before, but rolls less far. It bears no larger knock: robust means that the margins hold for many robots. The light of the certificate says whether the controller may drive the real robot. For it, 300 robots that differ a little are pushed in simulation, without the payload.",ask:"What is the largest knock from rest that it bears, and that the regulator of the step before bears? What else did robustness cost? Compare effort and travel in a report (Keep)."}],aM="This robot cannot be simulated. The one before it stands here again.",lM="That was too much at once: some of it was left out. Wait a moment.",cM="The simulation stopped and was started again. All robots stand upright.",hM="Your last change stopped the simulation for all. The usual robot stands here instead.",uM="left motor",dM="right motor",fM="The margins are for the kit's own dead time, {own} ms. The slider has {now} ms.",pM="Expected: {what}.",mM="Likely: {what}.",gM="Try: {what}.",_M="{job} was stopped.",vM="no controller",xM="{light}, without the payload",bM="{light}, on a level floor",yM="{light}, without the payload, on a level floor",MM={small:"stable, with small margins",usual:"stable, with usual margins",thin:"stable, a margin is thin",unstable:"unstable",free:"it may roll or turn away",doubles:"Unstable: a small deviation doubles every {time}",unheld:"Nothing holds its position or its heading",delay:"more delay at {place} makes it unstable; usual: {usual}",strength:"of the motors' strength keep it stable; usual: {usual}",phase:"phase margin at both motors; usual: {usual}",both:"both motors",range:"{low} to {high}",atLeast:"at least {low}",roomy:"{controller} holds {robot} with room to spare",unlessStronger:"{controller} holds {robot}, unless its motors are {size} stronger",unlessWeaker:"{controller} holds {robot}, unless its motors are {size} weaker",unlessLater:"{controller} holds {robot}, unless {place} is {size} later",withPhase:"{controller} holds {robot}, with a phase margin of {size}",stronger:"The thinnest margin: a gain {change} higher at {place} makes the loop unstable.",weaker:"The thinnest margin: a gain {change} lower at {place} makes the loop unstable."},SM="green",wM="amber",EM="red",TM="unknown",Ka={handIn:y_,handInNote:M_,noReplay:S_,noRun:w_,certify:E_,jobStopped:T_,results:A_,invite:R_,title:C_,skip:P_,connecting:L_,starting:D_,connected:I_,lost:N_,gone:U_,replaying:k_,refused:F_,theme:O_,help:B_,close:z_,scene:H_,sceneNow:V_,fellNow:G_,twin:W_,nonlinear:$_,linear:q_,published:X_,calibrated:j_,twinNote:Y_,nonlinearNote:K_,linearNote:Z_,publishedNote:J_,calibratedNote:Q_,hint:tv,moreCurves:ev,fewerCurves:nv,robotIs:iv,mark_impulse:sv,mark_front:ov,mark_back:rv,mark_pull_left:av,mark_pull_right:lv,mark_hand:cv,mark_held:hv,mark_stood:uv,best:dv,bestTip:fv,what:pv,newHere:mv,doing_certify:gv,doing_calibrate:_v,doing_doctor:vv,oneAtATime:xv,soFar:bv,stillTakes:yv,overdue:Mv,lightNote:Sv,fallen:wv,standUp:Ev,tilt:Tv,tiltTip:Av,pause:Rv,play:Cv,step:Pv,stepTip:Lv,speed:Dv,back:Iv,timeLine:Nv,lies:Uv,pushes:kv,front:Fv,frontTip:Ov,backPush:Bv,backTip:zv,impulse:Hv,impulseTip:Vv,pullLeft:Gv,pullRight:Wv,pullBoth:$v,pullTip:qv,size:Xv,sizeTip:jv,pitch:Yv,pitch_rate:Kv,wheel:Zv,wheel_rate:Jv,yaw:Qv,yaw_rate:tx,charts:ex,tabs:nx,tabController:ix,tabRobot:sx,tabKit:ox,tabSee:rx,tabIdentify:ax,tabKeep:lx,tabTour:cx,tabClass:hx,family:ux,lqg:dx,lqr:fx,"lqr-complementary":"LQR with a complementary filter","lqr-state":"LQR on the true state (simulation only)",lqi:px,pid:mx,hinf:gx,mpc:_x,sliding:vx,robust:xx,gains:bx,off:yx,noLoop:Mx,weights:Sx,command:wx,ownWeights:Ex,noWeights:Tx,fixedWeights:Ax,designed:Rx,noCertificateByHand:Cx,redesigned:Px,queued:Lx,calibratedLaden:Dx,designing:Ix,robustTakes:Nx,gain:Ux,gainNote:kx,saved:Fx,lookHere:Ox,mark_tilt:Bx,linkHere:zx,comparedThere:Hx,compared:Vx,saveAs:Gx,open:Wx,large:$x,fewer:qx,more:Xx,mark_self:jx,noCertificateHere:Yx,unlimited:Kx,certificate:Zx,none:Jx,tried:Qx,noCertificate:tb,noSuchRobot:eb,leftOut:nb,noSuchController:ib,certified:sb,fullCertificate:ob,preset:rb,openRobot:ab,numbers:lb,numbersNote:cb,ownNumbers:hb,payload:ub,payloadHeight:db,slope:fb,grip:pb,bodies:mb,kit:gb,ideal:_b,noise:vb,delay:xb,voltage:bb,deadZone:yb,ownKit:Mb,loop:Sb,viewLabel:wb,bode:Eb,nyquist:Tb,poles:Ab,portrait:Rb,voltages:Cb,voltagesNote:Pb,torquesNote:Lb,estimate:Db,estimateNote:Ib,noEstimate:Nb,equations:Ub,equationsNote:kb,truth:Fb,opinion:Ob,saturated:Bb,linearised:zb,openPoles:Hb,source:Vb,thisRun:Gb,openLog:Wb,doctor:$b,doctorTip:qb,calibrate:Xb,calibrateTip:jb,compare:Yb,compareTip:Kb,stop:Zb,comparing:Jb,compareWaits:Qb,calibrateNote:ty,keepNote:ey,keepData:ny,keepPages:iy,keepFiles:sy,keepShow:oy,csvNote:ry,keepLive:ay,csv:ly,parquet:cy,report:hy,replay:uy,controllerFile:dy,robotFile:fy,picture:py,link:my,linkCopied:gy,noPush:_y,namedPush:vy,knockPush:xy,heldPush:by,made:yy,recovered:My,recoveredMost:Sy,recoveredSeveral:wy,lostPush:Ey,lostPushes:Ty,uploaded:Ay,newtons:Ry,board:Cy,name:Py,bestPush:Ly,effort:Dy,broadcast:Iy,yourName:Ny,nameMissing:Uy,enter:ky,joinTitle:Fy,tourStep:Oy,tourDo:By,tourWatch:zy,tourAsk:Hy,tourSet:Vy,next:Gy,tourBack:Wy,writing:$y,previous:qy,keys:Xy,tabPython:jy,ghost:Yy,carries:Ky,stays:Zy,lookAtThis:Jy,lookTip:Qy,lookCopied:tM,pythonNote:eM,install:nM,copy:iM,copied:sM,python:oM,tour:rM,setBack:aM,tooMany:lM,restarted:cM,ended:hM,leftMotor:uM,rightMotor:dM,delayOwn:fM,expected:pM,likely:mM,tryThis:gM,wasStopped:_M,unlitOff:vM,litPayload:xM,litSlope:bM,litBoth:yM,loopSaid:MM,green:SM,amber:wM,red:EM,unknown:TM},AM="Entregar",RM="Para entregar: presione Poner de pie, empuje el robot y presione Entregar antes de un minuto, sin cambiar nada más. Guarda un archivo en este equipo: déselo a su docente.",CM="El kit de este robot es un archivo propio: su entrega no se puede repetir.",PM="No hay nada que entregar: presione Poner de pie, empuje el robot y entregue antes de un minuto.",LM="Certificar",DM="{job} se detuvo: {why}",IM="Resultados en CSV",NM="Para unirse a la clase",UM="upright lab",kM="Ir a los controles",FM="Conectando …",OM="La simulación está arrancando …",BM="En vivo",zM="Sin conexión; se intenta de nuevo",HM="El laboratorio no responde. Esta página sigue por sí sola cuando upright lab funcione otra vez.",VM="Grabación",GM="Esta página se ha detenido",WM="Claro u oscuro",$M="Qué hacen los botones, las teclas y el mouse",qM="Cerrar",XM="El robot en su sala. Arrastre su cuerpo para empujarlo; arrastre el suelo para cambiar la vista.",jM="{body} se inclina {pitch} grados y ha rodado {way} centímetros.",YM="{body} se ha caído.",KM="gemelo",ZM="modelo no lineal",JM="modelo lineal",QM="modelo publicado",tS="modelo calibrado",eS="El robot como lo simula MuJoCo, con contacto y fricción: hace las veces del robot real",nS="Las ecuaciones de movimiento completas del modelo, sin contacto",iS="El mismo modelo, linealizado en vertical: válido para ángulos pequeños",sS="El modelo con las ecuaciones tal como se publicaron",oS="El modelo con los parámetros que encontró Calibrar",rS="Se equilibra solo: arrástrelo para empujarlo",aS="Más curvas",lS="Menos curvas",cS="robot: {body}",hS="golpe {size} N s",uS="sostenido por delante",dS="sostenido por detrás",fS="tirón izquierdo",pS="tirón derecho",mS="empujón {size} N s",gS="empujón",_S="de pie",vS="mejor golpe {best} N s",xS="El mayor golpe solo, o empujón a mano de medio segundo como máximo, del que se recuperó. Un empujón más largo sostiene el robot y no cuenta. Tampoco uno dado antes de que se recupere de otro.",bS="Empuje un robot de dos ruedas y vea qué lo mantiene en pie",yS="¿Primera vez? Haga el recorrido",MS="1000 robots, cada uno algo distinto, se sostienen, se sueltan y reciben golpes en simulación: cerca de medio minuto.",SS="Se buscan los parámetros con los que el modelo predice mejor el registro.",wS="Se buscan fallas de unidades, signos, tiempo y sensores en el registro.",ES="Empieza pronto; los trabajos se hacen uno tras otro.",TS="{seconds} s hasta ahora",AS="faltan unos {seconds} s",RS="{seconds} s hasta ahora, más de lo previsto",CS="300 robots, cada uno algo distinto, reciben empujones en simulación. Tarda unos segundos.",PS="Se cayó.",LS="Poner de pie",DS="Inclinar",IS="El robot se pone de pie otra vez, inclinado 6°, y se suelta",NS="Pausa",US="Continuar",kS="Un paso",FS="En pausa: avanza un paso del controlador, unas milésimas de segundo",OS="Velocidad",BS="Atrás en el tiempo",zS="Tiempo",HS="Está caído; presione antes Poner de pie.",VS="Empujones",GS="Sostener por delante",WS="Una fuerza por delante que mantiene una inclinación de 5,7° durante 3 s y luego cesa (el primer empujón del artículo)",$S="Sostener por detrás",qS="Una fuerza por detrás que mantiene una inclinación de −6,9° durante 3 s y luego cesa (el segundo empujón del artículo)",XS="Dar un golpe",jS="Un golpe breve al cuerpo, del tamaño que está al lado (K)",YS="Tirón izq.",KS="Tirón der.",ZS="Tirón izq., Tirón der.",JS="Un tirón de una rueda durante 0,3 s, de un cuarto del peso del robot: gira",QS="Tamaño",tw="Fuerza por tiempo: 0,05 N s es lo que trae una manzana de 100 g a medio metro por segundo",ew="inclinación",nw="velocidad de inclinación",iw="ángulo de las ruedas",sw="velocidad de las ruedas",ow="guiñada",rw="velocidad de guiñada",aw="Trazas de los últimos segundos",lw="Ajustes, vistas y archivos",cw="Controlador",hw="Robot",uw="Kit",dw="Ver",fw="Identificar",pw="Guardar",mw="Recorrido",gw="Clase",_w="Método",vw="LQG: filtro de Kalman con retardo",xw="LQR con filtro de Kalman",bw="LQI: LQG con integral del ángulo de ruedas",yw="PID en cascada",Mw="H∞",Sw="MPC: predictivo, respeta límites",ww="Modo deslizante",Ew="Robusto: una ganancia para muchos robots",Tw="Ganancias a mano: u = −K x",Aw="Sin controlador",Rw="No hay controlador, así que no hay lazo.",Cw="Mayores desviaciones aceptadas (regla de Bryson): menor es más estricto",Pw="mando",Lw="Volver a los pesos por defecto",Dw="Este método no tiene pesos que ajustar aquí.",Iw="Los pesos de este controlador quedaron fijados al diseñarlo. Para cambiar algo aquí, elija Ganancias a mano. En el laboratorio en vivo (upright lab, con Python) también se pueden cambiar.",Nw="El nuevo controlador ya actúa: empuje el robot.",Uw="En esta página no hay certificado. El laboratorio en vivo lo calcula también para ganancias a mano: upright lab.",kw="Cada cambio aquí diseña de nuevo el controlador, para el kit tal como queda. Por eso un retardo mayor, si se conoce, daña menos.",Fw="espera al trabajo de Identificar",Ow="En este ensayo el robot llevaba {mass} g que su archivo no tiene. Ponga la carga en 0 en Robot, empuje y conduzca medio minuto, y calibre de nuevo.",Bw="Diseñando …",zw="Un diseño robusto tarda unos diez segundos, más en una máquina ocupada. Hasta entonces actúa otro controlador.",Hw="Ganancia K del motor izquierdo",Vw="u = −K x, en {unit} por rad y rad/s. ψ inclinación, θ ángulo de las ruedas, φ guiñada; el punto marca su velocidad.",Gw="Guardado; para guardarlo otra vez:",Ww="Enlace copiado. Abre esta página en este computador; para otras personas, póngala en un servidor web.",$w="inclinación {size}°",qw="Enlace copiado. Se abre en este computador. Para otros, inicie el laboratorio con upright lab --class.",Xw="La comparación está lista: está en la pestaña Identificar.",jw="Comparación lista:",Yw="Guardar {name}",Kw="Abrir",Zw="{what}: grande o pequeña",Jw="Menos",Qw="Más",t1="se mueve solo",e1="En esta página no hay certificado: la pestaña Python tiene su comando.",n1="sin límite",i1="Certificado",s1="calculando …",o1="{n} de {all} ensayos …",r1="ninguno",a1="Esta página no tiene el robot '{name}'; muestra {shown}. Tiene: {all}.",l1="Esta página deja fuera partes del enlace: {parts}.",c1="Esta página no tiene el controlador '{name}' para este robot; muestra {shown}. Tiene: {all}.",h1="El certificado completo está listo. También está en la pestaña Identificar.",u1="Certificado completo",d1="Robot",f1="Abrir robot.toml",p1="Parámetros",m1="El controlador se diseña para estos parámetros.",g1="Volver a los parámetros de fábrica",_1="Carga que el controlador desconoce",v1="Altura de la carga sobre el eje",x1="Pendiente del suelo",b1="Agarre de las ruedas, coeficiente de fricción (gemelo)",y1="Cuerpos",M1="Kit",S1="ideal: nada entre controlador y motores",w1="Ruido, redondeo y sesgo de los sensores",E1="Retardo del sensor al motor",T1="Batería",A1="Zona muerta de los motores",R1="Volver a los valores del kit",C1="Lazo: márgenes, Bode, Nyquist, polos",P1="Qué se ve",L1="Diagrama de Bode del lazo abierto en ambos motores",D1="Diagrama de Nyquist",I1="Polos en lazo cerrado",N1="Plano de fase",U1="Voltaje",k1="Voltaje en el motor izquierdo y en el derecho; las barras marcan saturación.",F1="Par del motor izquierdo y del derecho; las barras marcan saturación.",O1="Estimación",B1="La inclinación estimada por el controlador y la verdadera.",z1="Este controlador no estima el estado: lee el verdadero, o nada.",H1="Ecuaciones",V1="v en voltios, o en la unidad del par. A esto se suman fricción seca y de rodadura, pendiente y empujones.",G1="verdad",W1="estimación",$1="saturación",q1="Linealizado en vertical, ẋ = A x + B u",X1="Polos en lazo abierto",j1="Registro que se usa",Y1="este ensayo (el último minuto)",K1="Abrir un registro",Z1="Doctor",J1="Busca fallas del registro: unidades, signos, retardos, sesgo …",Q1="Calibrar",tE="Estima los parámetros del robot a partir de sus sensores; el modelo calibrado se muestra como otra traza",eE="Comparar",nE="Una página con números y figuras de todos los cuerpos en el último minuto, y del registro abierto",iE="Parar",sE="Comparando …",oE="Otro trabajo sigue en marcha; la comparación puede tardar más.",rE="Doctor: busca fallas del registro. Calibrar: halla en él los parámetros del robot; antes empuje y conduzca el robot medio minuto, después calcula de diez segundos a dos minutos. Comparar: una página con números y figuras de todos los cuerpos.",aE="Los archivos contienen el ensayo desde el último cambio, como mucho el último minuto.",lE="Datos, para una hoja de cálculo o para upright",cE="Páginas: números y figuras, o el ensayo para verlo otra vez",hE="Archivos, para los comandos de upright",uE="Para mostrarlo: una imagen, o un enlace a esta configuración",dE="Registro CSV: lo que muestran las curvas, como máximo el último minuto, para una hoja de cálculo o para upright. Imagen: el robot como se ve ahora.",fE="El informe y la página con la grabación requieren Python: los hace el laboratorio en vivo (upright lab).",pE="Registro CSV",mE="Registro Parquet",gE="Informe",_E="Página con la grabación",vE="Archivo del controlador",xE="Archivo del robot",bE="Imagen",yE="Copiar enlace",ME="Enlace copiado. Restaura toda esta configuración.",SE="No lleva ningún empujón.",wE="Repite el último empujón.",EE="Su empujón a mano va en él como un golpe del mismo impulso.",TE="Su empujón a mano fue demasiado largo para ir en él.",AE="{name} está listo",RE="Se recuperó de un empujón de {impulse} N s; el mayor hasta ahora {best} N s",CE="Se recuperó de un empujón de {impulse} N s, el mayor hasta ahora",PE="Se recuperó, pero no de un solo empujón: no es récord.",LE="Se cayó tras un empujón de {impulse} N s.",DE="Se cayó: varios empujones, {impulse} N s en total, antes de recuperarse.",IE="Se está leyendo {name}",NE="fuerza {force} N",UE="Clasificación",kE="Nombre",FE="Mayor empujón [N s]",OE="Esfuerzo",BE="Enviar mi configuración a todos",zE="Su nombre",HE="Escriba primero su nombre.",VE="Entrar",GE="Unirse a la clase",WE="Paso {n} de {all}",$E="Haga",qE="Observe",XE="Piense",jE="Preparar",YE="Siguiente",KE="Volver a mi robot",ZE="Escribiendo el archivo",JE="Anterior",QE=[["Mouse sobre el robot","arrastrar y mantener para empujar"],["Mouse sobre el suelo","arrastrar para cambiar la vista, rueda para acercarse"],["Un dedo","sobre el robot: empujarlo; al lado: cambiar la vista, de lado"],["← → ↑ ↓","girar y conducir; la palanca izquierda de un control de juegos hace lo mismo"],["F, B","empujar por delante, por detrás, mientras se mantenga la tecla"],["K","golpe"],["Espacio","pausa y continuar"],[".","un paso"],[", y /","atrás y adelante en el tiempo, en pausa"],["S","poner de pie"],["1, 2, 3 …","abrir la primera, segunda, tercera … pestaña"],["N, P","paso siguiente y anterior del recorrido; Intro lo prepara"],["[ ] { } + −","cambiar la vista y acercarse, con el foco en la sala"],["?","esta lista"]],tT="Python",eT="Modelo lineal como fantasma junto al robot",nT="Carga que el controlador desconoce: {mass} g, a {height} cm sobre el eje",iT="El controlador queda como se diseñó: para un suelo horizontal y el retardo propio del kit.",sT="Copiar enlace",oT="Un enlace a este robot y este controlador, y al último empujón; uno breve a mano pasa a ser un golpe",rT="Enlace copiado. Quien lo abra verá este robot y este controlador.",aT="Lo siguiente necesita upright, un programa para Python 3.11 o más nuevo. Quien hizo esta página tiene su carpeta: abra en ella una terminal y escriba una vez:",lT="pip install .",cT="Copiar",hT="Copiado.",uT=[["Un registro del gemelo de este robot, excitado para poder calibrar con él","upright example excited -o run.csv"],["Un registro del gemelo de este robot, inclinado, conducido y girado para poder calibrar con él","upright simulate -r {robot} -b twin -c lqg --start pitch=0.1 --drive {speed},start=1,until=4 --turn 1,start=2,until=5 -s 6 -o run.csv"],["Calibrar el robot a partir de ese registro","upright calibrate run.csv --robot {robot}"],["Diseñar este controlador, con sus márgenes, y guardarlo","upright design {controller} -r {robot} -o controller.json"],["Certificar este controlador","upright certify {controller} -r {robot}"],["Su propio robot, de un archivo, en una página como esta","upright lab --export site --robots mine.toml"],["El laboratorio en vivo, con el gemelo MuJoCo, cargas, otros kits y todos los parámetros","upright lab"]],dT=[{title:"Empújelo",do:"Presione Dar un golpe. O arrastre el robot con el mouse o con un dedo, y suéltelo.",watch:"Las ruedas avanzan bajo el cuerpo, y su inclinación ψ vuelve a cero. θ es el ángulo de las ruedas. Antes del primer empujón puede quedar quieto: los motores no responden a voltajes pequeños. O se mueve solo, donde el ruido de los sensores supera esa zona muerta. Una vez movido sigue oscilando un poco, por ambas causas.",ask:"¿Qué golpe aguanta como máximo? El deslizador Tamaño lo fija. El robot es el gemelo, que MuJoCo simula en lugar del robot real; los fantasmas pálidos son modelos más simples. ¿En qué se diferencian sus curvas en el segundo tras el golpe?",here:{watch:"Las ruedas avanzan bajo el cuerpo, y su inclinación ψ vuelve a cero. θ es el ángulo de las ruedas. Antes del primer empujón puede quedar quieto: los motores no responden a voltajes pequeños. O se mueve solo, donde el ruido de los sensores supera esa zona muerta. Una vez movido sigue oscilando un poco, por ambas causas.",ask:"¿Qué golpe aguanta como máximo? El deslizador Tamaño lo fija. El fantasma pálido junto al robot es un modelo más simple, lineal: ¿en qué se diferencia su curva en el segundo tras el golpe?"}},{title:"Se cae solo",do:"Presione Preparar: entonces nada controla el robot. Empieza con una inclinación de 1,1°, en cámara lenta (× 1/10).",watch:"Tras la primera décima de segundo ψ crece como una exponencial, porque un polo en lazo abierto está en el semiplano derecho. Su curva se muestra aquí hasta 17°.",ask:"¿Cuánto tarda la inclinación de 6° a 12°? Compare con ln 2 dividido entre el polo inestable (Ver, Ecuaciones). ¿Por qué tarda más la primera duplicación, desde el reposo?"},{title:"Linealizar",do:"Presione Preparar: solo arrancan los dos modelos, sin controlador, desde una inclinación pequeña. Caen en cámara lenta (× 1/10).",watch:"La inclinación ψ de ambos modelos coincide casi hasta el suelo. El ángulo de rueda θ se separa a mitad de camino.",ask:"¿Qué términos aproxima el modelo lineal? Mire sen ψ y cos ψ. ¿Por qué θ lo muestra antes que ψ?"},{title:"Regular",do:"Presione Preparar: ahora un LQR lo equilibra. Inclínelo. Luego ponga la inclinación aceptada en Controlador en unos 2,3°, e inclínelo otra vez.",watch:"Una inclinación aceptada menor da una ganancia mayor en ψ. Al inclinarlo, el cuerpo se inclina menos, pero regresa más despacio, y θ rueda más lejos: sus sensores no muestran cuánto se inclinó.",ask:"¿Cómo cambian los márgenes con una inclinación aceptada menor? Si se conociera todo el estado, una ganancia mayor lo haría regresar más rápido: ¿qué no se conoce aquí?",here:{do:"Presione Preparar: ahora un LQR lo equilibra. Inclínelo. Luego elija Ganancias a mano en Controlador. Lleve ψ inclinación → u a unos −50 e inclínelo otra vez; luego a unos −9.",watch:"Con −50 θ rueda el doble (460°, no 230°), y el mayor factor de ganancia que soporta baja de 1,29 a 1,12. Con −9 el cuerpo oscila varias veces. Al inclinarlo se inclina más al principio, hasta que sus sensores lo muestran.",ask:"¿Cómo cambian los márgenes con la ganancia en ψ? ¿Qué no saben sus sensores después de inclinarlo?"}},{title:"Empujar por delante",do:"Presione Preparar: tras un segundo una fuerza por delante mantiene ψ cerca de 5,7° durante 3 s y luego cesa.",watch:"El robot se inclina contra la fuerza, al principio un poco más, y rueda hacia atrás. Al soltarlo ψ pasa de cero hasta unos −1°, y las ruedas regresan.",ask:"¿Por qué un empujón por delante mantiene una inclinación hacia adelante? Piense en la suma de momentos."},{title:"Empujar por detrás",do:"Presione Preparar: tras un segundo una fuerza por detrás mantiene ψ cerca de −6,9° durante 3 s y luego cesa.",watch:"La misma respuesta, reflejada. La inclinación es un quinto mayor, y θ al menos otro tanto: cambia de un ensayo a otro. φ, en Más curvas, apenas se mueve.",ask:"¿Es la respuesta exactamente la imagen reflejada? ¿Qué haría diferentes los dos lados?"},{title:"Comparar",do:"Presione Preparar: el gemelo y los modelos se sostienen del mismo modo y se sueltan. Cuando estén de pie otra vez, abra Identificar y presione Comparar.",watch:"Los tres coinciden. Lo que queda es sobre todo ruido: los tiempos de asentamiento saltan décimas de segundo de un ensayo a otro. Presione Preparar otra vez y compare.",ask:"El empujón es pequeño: ¿por qué el modelo lineal es tan bueno como el no lineal? ¿Qué señal muestra más el ruido?"},{title:"Romper el modelo lineal",do:"Presione Preparar: el robot lleva 200 g, a 30 cm sobre el eje, que ni el controlador ni el modelo lineal incluyen. Dele un golpe suave, luego uno más fuerte.",watch:"Puede empezar a oscilar solo. Tras un golpe suave el fantasma lineal casi vuelve al reposo, y el gemelo sigue oscilando mucho. Con 0,3 N s cae el fantasma, aunque aguantó ese golpe en el primer paso. El golpe da en el centro de masa del robot cargado. Este está más alto, y por eso hace girar al fantasma, que no lleva carga, al doble de velocidad.",ask:"¿Por qué el robot cargado aguanta este golpe desde el reposo, pero no siempre mientras oscila? ¿Qué carga lleva como máximo?",here:{do:"Presione Preparar: el robot lleva 300 g, a 30 cm sobre el eje, que ni el controlador ni el modelo lineal incluyen. Dele un golpe suave, luego uno más fuerte.",watch:"Puede empezar a oscilar solo. Tras un golpe suave el fantasma lineal casi vuelve al reposo, y el robot sigue oscilando mucho. Con 0,3 N s cae el fantasma, aunque aguantó ese golpe en el primer paso. El golpe da en el centro de masa del robot cargado. Este está más alto, y por eso hace girar al fantasma, que no lleva carga, al doble de velocidad.",ask:"¿Por qué el robot cargado aguanta este golpe desde el reposo, pero no siempre mientras oscila? ¿Puede llevar la carga con ganancias a mano?"}},{title:"Hacerlo robusto",do:"Presione Preparar: un diseño robusto tiene una ganancia para muchos robots. Tarda unos diez segundos. La carga sigue puesta. Repita sus empujones.",watch:"El robot cargado oscila tanto como antes, pero rueda menos. No aguanta un golpe mayor: robusto significa que los márgenes valen para muchos robots. La luz del certificado dice si el controlador puede conducir el robot real. Para ella, 300 robots algo distintos reciben empujones en simulación, sin la carga.",ask:"¿Cuál es el mayor golpe que aguanta desde el reposo, y cuál aguanta el regulador del paso anterior? ¿Qué más costó la robustez? Compare esfuerzo y recorrido en un informe (Guardar)."}],fT="Este robot no se puede simular. El anterior está de nuevo aquí.",pT="Fue demasiado a la vez: una parte se omitió. Espere un momento.",mT="La simulación se detuvo y comenzó de nuevo. Todos los robots están de pie.",gT="Su último cambio detuvo la simulación para todos. Aquí está el robot habitual en su lugar.",_T="motor izquierdo",vT="motor derecho",xT="Los márgenes son para el retardo propio del kit, {own} ms. El deslizador tiene {now} ms.",bT="Se esperaba: {what}.",yT="Probablemente: {what}.",MT="Pruebe: {what}.",ST="{job} se detuvo.",wT="sin controlador",ET="{light}, sin la carga",TT="{light}, en suelo horizontal",AT="{light}, sin la carga, en suelo horizontal",RT={small:"estable, con márgenes pequeños",usual:"estable, con márgenes usuales",thin:"estable, un margen es escaso",unstable:"inestable",free:"puede rodar o girar",doubles:"Inestable: una pequeña desviación se duplica cada {time}",unheld:"Nada mantiene su posición ni su guiñada",delay:"más de retardo en {place} lo vuelven inestable; habitual: {usual}",strength:"de la fuerza de los motores lo mantiene estable; habitual: {usual}",phase:"margen de fase en ambos motores; habitual: {usual}",both:"ambos motores",range:"{low} a {high}",atLeast:"al menos {low}",roomy:"{controller} sostiene {robot} con holgura",unlessStronger:"{controller} sostiene {robot}, salvo con motores {size} más fuertes",unlessWeaker:"{controller} sostiene {robot}, salvo con motores {size} más débiles",unlessLater:"{controller} sostiene {robot}, salvo con {size} más de retardo en {place}",withPhase:"{controller} sostiene {robot}, con un margen de fase de {size}",stronger:"El margen más estrecho: una ganancia {change} mayor en {place} vuelve inestable el lazo.",weaker:"El margen más estrecho: una ganancia {change} menor en {place} vuelve inestable el lazo."},CT="verde",PT="ámbar",LT="rojo",DT="desconocido",Wp={handIn:AM,handInNote:RM,noReplay:CM,noRun:PM,certify:LM,jobStopped:DM,results:IM,invite:NM,title:UM,skip:kM,connecting:FM,starting:OM,connected:BM,lost:zM,gone:HM,replaying:VM,refused:GM,theme:WM,help:$M,close:qM,scene:XM,sceneNow:jM,fellNow:YM,twin:KM,nonlinear:ZM,linear:JM,published:QM,calibrated:tS,twinNote:eS,nonlinearNote:nS,linearNote:iS,publishedNote:sS,calibratedNote:oS,hint:rS,moreCurves:aS,fewerCurves:lS,robotIs:cS,mark_impulse:hS,mark_front:uS,mark_back:dS,mark_pull_left:fS,mark_pull_right:pS,mark_hand:mS,mark_held:gS,mark_stood:_S,best:vS,bestTip:xS,what:bS,newHere:yS,doing_certify:MS,doing_calibrate:SS,doing_doctor:wS,oneAtATime:ES,soFar:TS,stillTakes:AS,overdue:RS,lightNote:CS,fallen:PS,standUp:LS,tilt:DS,tiltTip:IS,pause:NS,play:US,step:kS,stepTip:FS,speed:OS,back:BS,timeLine:zS,lies:HS,pushes:VS,front:GS,frontTip:WS,backPush:$S,backTip:qS,impulse:XS,impulseTip:jS,pullLeft:YS,pullRight:KS,pullBoth:ZS,pullTip:JS,size:QS,sizeTip:tw,pitch:ew,pitch_rate:nw,wheel:iw,wheel_rate:sw,yaw:ow,yaw_rate:rw,charts:aw,tabs:lw,tabController:cw,tabRobot:hw,tabKit:uw,tabSee:dw,tabIdentify:fw,tabKeep:pw,tabTour:mw,tabClass:gw,family:_w,lqg:vw,lqr:xw,"lqr-complementary":"LQR con filtro complementario","lqr-state":"LQR con el estado verdadero (solo simulado)",lqi:bw,pid:yw,hinf:Mw,mpc:Sw,sliding:ww,robust:Ew,gains:Tw,off:Aw,noLoop:Rw,weights:Cw,command:Pw,ownWeights:Lw,noWeights:Dw,fixedWeights:Iw,designed:Nw,noCertificateByHand:Uw,redesigned:kw,queued:Fw,calibratedLaden:Ow,designing:Bw,robustTakes:zw,gain:Hw,gainNote:Vw,saved:Gw,lookHere:Ww,mark_tilt:$w,linkHere:qw,comparedThere:Xw,compared:jw,saveAs:Yw,open:Kw,large:Zw,fewer:Jw,more:Qw,mark_self:t1,noCertificateHere:e1,unlimited:n1,certificate:i1,none:s1,tried:o1,noCertificate:r1,noSuchRobot:a1,leftOut:l1,noSuchController:c1,certified:h1,fullCertificate:u1,preset:d1,openRobot:f1,numbers:p1,numbersNote:m1,ownNumbers:g1,payload:_1,payloadHeight:v1,slope:x1,grip:b1,bodies:y1,kit:M1,ideal:S1,noise:w1,delay:E1,voltage:T1,deadZone:A1,ownKit:R1,loop:C1,viewLabel:P1,bode:L1,nyquist:D1,poles:I1,portrait:N1,voltages:U1,voltagesNote:k1,torquesNote:F1,estimate:O1,estimateNote:B1,noEstimate:z1,equations:H1,equationsNote:V1,truth:G1,opinion:W1,saturated:$1,linearised:q1,openPoles:X1,source:j1,thisRun:Y1,openLog:K1,doctor:Z1,doctorTip:J1,calibrate:Q1,calibrateTip:tE,compare:eE,compareTip:nE,stop:iE,comparing:sE,compareWaits:oE,calibrateNote:rE,keepNote:aE,keepData:lE,keepPages:cE,keepFiles:hE,keepShow:uE,csvNote:dE,keepLive:fE,csv:pE,parquet:mE,report:gE,replay:_E,controllerFile:vE,robotFile:xE,picture:bE,link:yE,linkCopied:ME,noPush:SE,namedPush:wE,knockPush:EE,heldPush:TE,made:AE,recovered:RE,recoveredMost:CE,recoveredSeveral:PE,lostPush:LE,lostPushes:DE,uploaded:IE,newtons:NE,board:UE,name:kE,bestPush:FE,effort:OE,broadcast:BE,yourName:zE,nameMissing:HE,enter:VE,joinTitle:GE,tourStep:WE,tourDo:$E,tourWatch:qE,tourAsk:XE,tourSet:jE,next:YE,tourBack:KE,writing:ZE,previous:JE,keys:QE,tabPython:tT,ghost:eT,carries:nT,stays:iT,lookAtThis:sT,lookTip:oT,lookCopied:rT,pythonNote:aT,install:lT,copy:cT,copied:hT,python:uT,tour:dT,setBack:fT,tooMany:pT,restarted:mT,ended:gT,leftMotor:_T,rightMotor:vT,delayOwn:xT,expected:bT,likely:yT,tryThis:MT,wasStopped:ST,unlitOff:wT,litPayload:ET,litSlope:TT,litBoth:AT,loopSaid:RT,green:CT,amber:PT,red:LT,unknown:DT},Dh={en:Ka,es:Wp},IT=[["en","English"],["es","Español"]];let yi=Ka;function Oo(){return yi===Wp?"es":"en"}function ud(i){yi=Dh[i]??Ka,document.documentElement.lang=Oo(),document.title=yi.title}function Za(){return yi}function F(i,t={}){return ni(yi[i],t)}function ni(i,t){return i.replace(/\{(\w+)\}/g,(e,n)=>NT(String(t[n]??"")))}function Ye(i){const t=yi[i];return typeof t=="string"?t:i}function hs(i){return yi===Ka?i:i.replace(/(\d)\.(?=\d)/g,"$1,")}function ii(i,t){return hs(i.toFixed(t).replace("-","−"))}function NT(i){return/^[−-]?\d+\.\d+$/.test(i)?hs(i):i}function UT(i){const t=yi,e=Object.entries(Dh).map(([n,s])=>(yi=s,[n,i()]));return yi=t,Object.fromEntries(e)}function Gi(i){return i[Oo()]??i.en}function Ih(i){return i.charAt(0).toUpperCase()+i.slice(1)}function Mr(i){const{came:t,expected:e,likely:n,hint:s}=Gi(i),o=/[.!?…]$/.test(t)?t:`${t}.`;return[Ih(o),e&&F("expected",{what:e}),n&&F("likely",{what:n}),s&&F("tryThis",{what:s})].filter(Boolean).join(" ")}function U(i,t,...e){const[n,...s]=i.split("."),o=document.createElement(n);s.length&&(o.className=s.join(" "));const r=!t||typeof t=="string"||t instanceof Node;for(const[a,l]of Object.entries(r?{}:t))a.startsWith("on")?o.addEventListener(a.slice(2),l):a.includes("-")||a==="role"||a==="for"||a==="list"?o.setAttribute(a,String(l)):l!==void 0&&(o[a]=l);return o.append(...$p(r?[t,...e]:e)),o}function $p(i){return i.filter(t=>!!t)}function de(i,t={},...e){const n=document.createElementNS("http://www.w3.org/2000/svg",i);for(const[s,o]of Object.entries(t))n.setAttribute(s,String(o));return n.append(...e),n}function jt(i,...t){zs(()=>i.replaceChildren(...$p(t)))}function Ml(i,t,...e){i.style.minHeight=t?`${i.getBoundingClientRect().height}px`:"",jt(i,t&&U("div"),...e)}function zs(i){const t=document.activeElement?.dataset?.key;i(),t&&document.activeElement===document.body&&document.querySelector(`[data-key="${t}"]`)?.focus({preventScroll:!0})}const qp=new WeakMap;function un(i){const t=U("span.said",i());return qp.set(t,i),t}function Nh(i){for(const t of i.querySelectorAll(".said"))t.textContent=qp.get(t)?.()??""}function ne(i,t,e,n={}){return U("button",{type:"button",onclick:t,"data-key":e,...n},i)}function vc(i,t){return i.ctrlKey||i.metaKey||i.altKey||i.composedPath()[0].matches(t)}let dd=0;function Ws(i){return dd+=1,`${i}-${dd}`}function Xp(i,t){const e=U("input",{type:"text",inputMode:"decimal",autocomplete:"off",className:"number",...t,onchange:()=>{const s=e.value.trim().replace("−","-").replace(",","."),o=s!==""&&Number.isFinite(Number(s));e.setAttribute("aria-invalid",String(!o)),o&&(n(Number(s)),i(Number(s)))}}),n=s=>e.value=hs(String(s).replace("-","−"));return{root:e,set:s=>{document.activeElement!==e&&(n(s),e.removeAttribute("aria-invalid"))}}}function Ca(i,t,e){const n=Ws("slider"),s=p=>t.log?Math.log(p):p,o=p=>t.log?Math.exp(p):p,r=s(t.high)-s(t.low),a=U("input",{type:"range",id:n,min:String(s(t.low)),max:String(s(t.high)),step:String(t.step??r/200),"data-key":t.key??""}),l=p=>!t.log&&Math.abs(p)<1e-6*r?0:p,c=t.typed===void 0?null:Xp(p=>{a.value=String(s(p)),a.setAttribute("aria-valuetext",t.show(p)),e(p)},{"aria-label":i,"data-key":`${t.key??""}-typed`}),h=c?U("span.typed",c.root,` ${t.typed}`):U("output",{for:n}),u=p=>{c?c.set(Number(p.toPrecision(4))):h.textContent=t.show(p),a.setAttribute("aria-valuetext",t.show(p))};a.addEventListener("input",()=>{const p=l(o(Number(a.value)));u(p),e(p)});const d=p=>{document.activeElement!==a&&(a.value=String(s(Math.max(p,t.log?t.low:-1/0)))),u(p)};return{root:U("div.slider",U("label",{for:n},i),h,a),set:d}}function us(i,t,e,n,s=""){const o=Ws("select"),r=U("select",{id:o,"data-key":s,onchange:()=>n(r.value)},...t.map(([a,l])=>U("option",{value:a,selected:a===e},l)));return U("div.choice",U("label",{for:o},i),r)}function Uh(i,t,e){const n=i.querySelector(`[data-key=${t}]`);n&&document.activeElement!==n&&(n.value=e)}function fe(i,t=3){return Number.isFinite(i)?hs(jp(String(Number(i.toPrecision(t))))):"∞"}function kh(i){return`${hs(jp(String(Number((i*180/Math.PI).toFixed(1)))))}°`}function jp(i){const t=(e,n)=>` ×10${e==="-"?"⁻":""}${n.replace(/\d/g,s=>"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(s)])}`;return i.replace(/(?<=\d)e([+-]?)0*(\d+)\b/g,(e,n,s)=>t(n,s)).replace(/(?<=^|[\s(…])-(?=\.?\d)/g,"−")}function Yp(i,t,e=""){const n=i.length?U("thead",U("tr",...i.map(o=>U("th",{scope:"col"},o)))):null,s=U("tbody",...t.map(o=>U("tr",...o.map(r=>U("td",r)))));return U("div.table",{tabIndex:0,"data-key":e&&`table-${e}`},U("table",{className:e},n,s))}function Kp(i,t){let e=0,n=null;return(...s)=>{n=s,!e&&(t(...s),n=null,e=window.setTimeout(function o(){if(e=0,n){const r=n;n=null,t(...r),e=window.setTimeout(o,i)}},i))}}const kT={twin:"#0072b2",nonlinear:"#d55e00",linear:"#00805c",calibrated:"#a0478a",published:"#6b6b00"},FT={twin:"#56b4e9",nonlinear:"#f2843c",linear:"#2fc79b",calibrated:"#dd93bd",published:"#c9c95a"},OT={nonlinear:[7,4],linear:[2,3],calibrated:[9,3,2,3],published:[12,5]};function BT(){return document.documentElement.dataset.theme==="dark"}function rs(i){const t=i==="nonlinear"&&"uprightExport"in globalThis?"twin":i;return(BT()?FT:kT)[t]??"#888888"}function Fh(i,t){return i===t[0]?[]:OT[i]??[]}function ds(){const i=getComputedStyle(document.documentElement),t=e=>i.getPropertyValue(e).trim();return{text:t("--ink"),soft:t("--soft"),grid:t("--grid"),push:t("--push")}}const fd={front:[0,.5],back:[-.5,0],impulse:[-20,20],pull_left:[-100,100],pull_right:[-100,100],tilt:[-1.2,1.2]},zT=.5;class HT{push=null;kept="noPush";hand={from:0,at:0,force:0,impulse:0,on:!1};note(t,e){t.kind==="Strike"?this.name([t.what,t.size]):t.kind==="StandUp"&&t.pitch?this.name(["tilt",t.pitch]):t.kind==="Drag"&&this.drag(t.force,e)}name(t){[this.push,this.kept]=[t,t?"namedPush":"noPush"]}drag(t,e){const{hand:n}=this;if(!n.on&&!t)return;n.on||Object.assign(n,{from:e,at:e,force:0,impulse:0,on:!0}),n.impulse+=n.force*(e-n.at),[n.at,n.force,n.on]=[e,t,t!==0];const s=e-n.from<=zT;[this.push,this.kept]=s?[["impulse",Number(n.impulse.toPrecision(4))],"knockPush"]:[null,"heldPush"]}}function VT(i){const[t,e]=(new URLSearchParams(i.replace(/^#/,"")).get("push")??"").split(":"),[n,s]=Object.hasOwn(fd,t)?fd[t]:[0,-1];return Number(e)>=n&&Number(e)<=s?[t,Number(e)]:null}function GT([i,t]){return i==="tilt"?{kind:"StandUp",pitch:t}:{kind:"Strike",what:i,size:t}}const _a={slope:[-.35,.35],noise:[0,20],delay:[-1,.2],voltage:[-1,60],dead_zone:[-1,5],grip:[.02,10],seed:[0,2**31],payload:[0,5],payload_height:[0,1]},Oh=Object.keys(_a),Zp={gains:6,largest:7},pd=40,Jp=i=>new URLSearchParams(i.replace(/^#/,"")),Hr=i=>i.length>pd?i.slice(0,pd)+"…":i,Sl=i=>String(Number(i.toPrecision(6)));function Pa(i){const t=["robot","controller","kit","bodies","numbers","push",...Oh,...Object.keys(Zp)];return[...Jp(i).keys()].some(e=>t.includes(e))}function WT(i,t,{usual:e,robots:n,keys:s}){const o=new URLSearchParams({robot:i.robot,controller:i.controller}),r=(l,c)=>s.includes(l)&&o.set(l,c);i.kit!==n[i.robot]?.kit&&r("kit",i.kit),i.controller==="gains"&&i.gains.length&&r("gains",i.gains.map(Sl).join()),i.largest.length&&r("largest",i.largest.map(Sl).join()),i.drive&&r("drive",i.drive),Object.keys(i.numbers).length&&r("numbers",Object.entries(i.numbers).map(([l,c])=>`${l}:${String(c)}`).join());for(const l of Oh)i[l]!==e[l]&&r(l,Sl(i[l]));const a=i.bodies.filter(l=>l!=="calibrated");return a.length&&a.join()!==e.bodies.join()&&r("bodies",a.join()),t&&o.set("push",`${t[0]}:${Number(t[1].toPrecision(4))}`),"#"+o.toString().replaceAll("%2C",",").replaceAll("%3A",":")}function $T(i,t){const e=Jp(i),[n,s]=[e.get("robot")??"",e.get("controller")??""],o=qT(e.get("numbers")??"",t.parameters),r=t.keys.includes("drive")&&e.has("drive")&&Object.keys(o).length===t.parameters.length,a=Object.hasOwn(t.robots,n),l={...t.usual,robot:a||n&&r?n:t.usual.robot},c=t.robots[l.robot]??t.robots[t.usual.robot];c.controllers.includes(s)&&(l.controller=s),l.kit=c.kit??l.kit;const h=(g,[m,f])=>g.trim()&&Number(g)>=m&&Number(g)<=f?Number(g):void 0,u=(g,m)=>[g.split(",").map(Number)].find(f=>f.length===m&&f.every(Number.isFinite)),d={...Object.fromEntries(Oh.map(g=>[g,m=>h(m,_a[g])])),...Object.fromEntries(Object.entries(Zp).map(([g,m])=>[g,f=>u(f,m)])),seed:g=>h(Number.isInteger(Number(g))?g:"",_a.seed),payload:g=>h(g,c.load===void 0?_a.payload:c.load?[c.load.payload,c.load.payload]:[0,0]),kit:g=>t.kits.find(m=>m===g),drive:g=>["voltage","torque","speed"].find(m=>m===g),numbers:g=>Object.keys(o).length===g.split(",").length?o:void 0,bodies:g=>[t.bodies.filter(m=>g.split(",").includes(m))].find(m=>m.length===g.split(",").length)},p=[];for(const[g,m]of e){if(!Object.hasOwn(d,g))continue;const f=t.keys.includes(g)?d[g](m):void 0;f===void 0?p.push(Hr(`${g}=${m}`)):Object.assign(l,{[g]:f})}const _=VT(i);return e.has("push")&&!_&&p.push(Hr(`push=${e.get("push")??""}`)),{setup:l,push:_,left:p,robot:l.robot===n?"":Hr(n),controller:l.controller===s?"":Hr(s)}}function qT(i,t){const e=i.split(",").map(n=>n.split(":"));return Object.fromEntries(e.filter(([n,s])=>t.includes(n)&&s?.trim()&&Number.isFinite(Number(s))).map(([n,s])=>[n,Number(s)]))}function XT(i){return/[#&]token=([\w-]+)/.exec(i)?.[1]??""}const jT=10,md=.04,YT=.25,[gd,_d,vd]=[.5,2,30],Hi={robot:"nxtway-gs",numbers:{},drive:"",kit:"nxt",noise:1,delay:-1,voltage:-1,dead_zone:-1,grip:10,bodies:["twin","nonlinear","linear"],controller:"lqg",largest:[],gains:[],payload:0,payload_height:.15,slope:0,seed:0},$s=["pitch","pitch_rate","wheel","wheel_rate","yaw","yaw_rate"],Qp=["rad","rad/s","rad","rad/s","rad","rad/s"],tm=Qp.map(i=>i.replace("rad","°")),Ja=180/Math.PI,Hs=["ψ","ψ̇","θ","θ̇","φ","φ̇"],Qa=.02,xd=3200,KT=.15,bd=1e3,ZT=.03,[JT,QT]=[.1,2],[tA,yd]=[2,.05],eA=["bodies","payload","payload_height","slope","grip","seed"];function Vr(i){return JSON.stringify(Object.entries(i).filter(([t])=>!eA.includes(t)))}function Md({robot:i,drive:t,kit:e,controller:n}){return[i,t,e,n].join()}function Sd(i){return JSON.stringify(Object.entries(i).sort(([t],[e])=>t<e?-1:1))}class Bh{t=[];x=[];estimate=[];volts=[[],[]];saturated=[];marks=[];breaks=[];other=!1;from=-1/0;begin(t){this.reset(this.x.length),this.from=t,this.other=!1}since(t){return this.t.findLastIndex(e=>e<t)+1}reset(t){this.from=-1/0,this.t=[],this.x=Array.from({length:t},()=>$s.map(()=>[])),this.estimate=[],this.volts=[[],[]],this.saturated=[],this.breaks=[],this.marks=[]}add(t){const e=this.t.at(-1);if(!(t.t<=this.from||e!==void 0&&t.t<e)){if(t.t===e){const n=this.t.length-1;if(t.x.length!==this.x.length||this.x.every((s,o)=>s.every((r,a)=>r[n]===t.x[o][a])))return;this.pop()}t.x.length!==this.x.length&&this.reset(t.x.length),this.push(t.t,t.x,t.e[0]??NaN,t.x[0][6],t.x[0][7],t.s),this.t.length>xd+400&&this.cut(this.t.length-xd)}}push(t,e,n,s,o,r){(this.other||this.jumps(t,e))&&this.breaks.push([this.t.at(-1)??t,t]),this.other=!1,this.t.push(t),e.forEach((a,l)=>this.x[l].forEach((c,h)=>c.push(a[h]))),this.estimate.push(n),this.volts[0].push(s),this.volts[1].push(o),this.saturated.push(r)}pop(){for(const t of this.all())t.pop();this.other=!0}jumps(t,e){const[n,s]=[this.t.length-1,t-(this.t.at(-1)??t)],o=(r,a,l)=>Math.abs(r[l]-a[l][n])>JT+QT*s*Math.max(Math.abs(r[l+1]),Math.abs(a[l+1][n]));return n>=0&&e.some((r,a)=>[0,2,4].some(l=>o(r,this.x[a],l)))}fill(t,e){if(!e.length)return;const n=Math.floor(e[0].length/6);(n!==this.x.length||(this.t.at(-1)??0)>t.at(-1)+1)&&this.reset(n);const s=new Bh;s.reset(n);let o=0;const r=a=>{for(;o<t.length&&t[o]<a-.001;o+=1){if(t[o]<=this.from||t[o]-(s.t.at(-1)??-1/0)<ZT)continue;const[l,c]=[e[o],e[o].slice(6*n)];s.push(t[o],Array.from({length:n},(h,u)=>l.slice(6*u,6*u+6)),c[0],c[1],c[2],c[3])}};this.t.forEach((a,l)=>{r(a),s.push(a,this.x.map(c=>c.map(h=>h[l])),this.estimate[l],this.volts[0][l],this.volts[1][l],this.saturated[l])}),r(1/0),s.breaks.push(...this.breaks),s.marks.push(...this.marks),Object.assign(this,s,{from:this.from,other:this.other})}until(t){const e=this.since(t);for(const n of this.all())n.length=e;this.marks=this.marks.filter(n=>n.t<t)}cut(t){for(const e of this.all())e.splice(0,t);this.marks=this.marks.filter(e=>e.t>=this.t[0])}all(){return[this.t,this.estimate,...this.volts,this.saturated,...this.x.flat()]}}const em={kind:"Light",light:"none",heads:{}};class nA{snapshot=null;traces=new Bh;changed=null;catalogue=null;analysed=null;equations=null;lit=null;trying=null;jobs=new Set;ceiling=null;board=null;found=null;certified=null;role="alone";session="";files="";invite="";setup=Hi;last=new HT;corrected=()=>{};say=()=>{};recorded=0;send=()=>{};listeners=[];sent=null;waiting=!1;asked=[];fresh=!1;lain=null;recalled=-bd;rest;missing=1/0;get falls(){return this.off||this.analysed?.stable===!1}get off(){return this.setup.controller==="off"}get byHand(){return this.setup.controller==="gains"}get unit(){return this.changed?.look.command_unit??"V"}anew(t){this.fresh=!0,t(),this.fresh&&this.traces.begin(1/0)}acted(t){this.sent?.what==="stood"&&(this.rest={wheel:0,from:t}),this.fresh?this.traces.begin(t):this.sent&&(this.sent.t=t),this.fresh=!1,this.sent=null}get settled(){return this.snapshot!==null&&!this.waiting&&this.changed?.busy===!1}note(t,e){const{hand:n}=this.last,{marks:s}=this.traces,o=n.on;["Change","Drag","Strike","Steer","StandUp"].includes(t.kind)&&(this.rest=null),this.last.note(t,e),t.kind==="Strike"?s.push({t:e,what:t.what,size:t.size}):t.kind==="StandUp"?s.push({t:e,what:t.pitch?"tilt":"stood",size:t.pitch}):n.on&&!o?s.push({t:e,what:"hand",size:0}):o&&s.at(-1)?.what==="hand"&&(s.at(-1).size=n.impulse),(t.kind==="Strike"||t.kind==="StandUp"||n.on&&!o)&&(this.sent=s.at(-1)??null)}listen(t){this.listeners.push(t)}change(t){t.robot!==void 0&&t.robot!==this.setup.robot&&this.last.name(null),this.expect(t),this.corrected(),this.ceiling=null,this.asked.push(Sd(this.setup)),this.send({kind:"Change",setup:this.setup})}push(t){(t.kind==="Strike"||t.force!==0)&&this.snapshot?.x[0][8]?this.hear({kind:"Notice",level:"info",parts:{},key:"lies",job:""}):this.send(t)}expect(t){const e=Vr(this.setup);this.setup={...this.setup,...t},Vr(this.setup)!==e&&(this.waiting=!0,this.forget())}forget(){this.analysed=null,this.certified=null,this.trying=null,this.lit=em;for(const t of this.listeners)t(this.lit)}alone({t,x:[e]}){if(this.rest===void 0&&(this.rest=t<tA&&!this.recorded?{wheel:e[2],from:t}:null),!this.rest||t<=this.rest.from||this.falls||Math.abs(e[2]-this.rest.wheel)<yd)return;const{rest:n,traces:s}=this,o=s.t.findIndex((r,a)=>r>n.from&&Math.abs(s.x[0][2][a]-n.wheel)>=yd);s.marks.push({t:s.t[o]??t,what:"self",size:0}),this.rest=null}recall(t){const e=this.traces.t.at(-1);e!==void 0&&t.t-e>=KT&&(this.missing=Math.min(this.missing,e)),!(this.missing===1/0||performance.now()-this.recalled<bd)&&(this.recalled=performance.now(),this.send({kind:"Recall",since:this.missing}),this.missing=1/0)}hear(t){switch(t.kind){case"Snapshot":this.snapshot=t,this.sent?.what==="hand"&&t.f[0]&&([this.sent.t,this.sent]=[t.t,null]),t.back||(this.lain=t.x.every(e=>e[8])?this.lain??t.t:null),t.back||(this.recall(t),this.traces.add(t),this.alone(t));break;case"Welcome":this.traces.from=-1/0,this.asked=[],this.jobs.clear(),this.role=t.role,this.session=t.session,this.files=t.files,this.invite=t.invite;break;case"Catalogue":this.catalogue=t;break;case"Changed":this.changedTo(t);break;case"Analysed":if(this.waiting)return;this.analysed=t;break;case"Equations":this.equations=t;break;case"Light":if(this.waiting)return;this.lit=t,this.trying=null;break;case"Progress":t.job==="light"&&t.runs&&!this.waiting&&(this.trying=t),t.job!=="light"&&t.job!=="design"&&(t.fraction<1?this.jobs.add(t.job):this.jobs.delete(t.job));break;case"Acted":this.acted(t.t);break;case"Board":this.board=t;break;case"JobResult":this.found=t,t.job==="certify"&&(this.certified=t);break;case"Notice":t.key==="tooMany"&&this.changed&&(this.asked=[],this.hear(this.changed));break;case"History":this.traces.fill(t.t,t.rows);break}for(const e of this.listeners)e(t)}outdated(t){const e=this.asked.indexOf(Sd(t));return this.asked=e<0?[]:this.asked.slice(e+1),this.asked.length>0}changedTo(t){const e=this.changed?.bodies.join()===t.bodies.join(),n=this.changed,s=n!==null&&Vr(n.setup)!==Vr(t.setup);this.changed=t;const o=this.outdated(t.setup);this.traces.other||=n!==null&&(Md(n.setup)!==Md(t.setup)||n.busy&&!t.busy),s&&!this.waiting&&this.forget(),o||([this.waiting,this.setup]=[!1,t.setup]),e||this.traces.reset(t.bodies.length)}}const C=new nA,iA=13,sA=10.5,xc=["stood","self"],oA=5,rA=2;function aA({what:i,size:t}){const e=Ye(t||i!=="hand"?`mark_${i}`:"mark_held"),n=e.replace(/(?<=\{size\}).*/,""),s=Math.abs(i==="tilt"?Ja*t:t);return[...new Set([e,n])].map(o=>o.replace("{size}",fe(s,2)))}class lA{root=U("div.marks");shown="";draw(t,e){const{ctx:n,bbox:{left:s,top:o,width:r,height:a}}=t,l=e*devicePixelRatio,{push:c,soft:h}=ds();let u=s+r+16*l;const d=[],p=C.traces.marks.map(_=>({mark:_,x:t.valToPos(_.t,"x",!0)})).filter(({x:_})=>_>=s&&_<=s+r);n.save(),n.lineWidth=l,n.setLineDash([3*l,3*l]),n.font=`${sA*l}px system-ui, sans-serif`;for(const{mark:_,x:g}of p.reverse()){n.strokeStyle=xc.includes(_.what)?h:c,n.beginPath(),n.moveTo(g,o),n.lineTo(g,o+a),n.stroke();const m=rA*l,f=Math.min(...p.map(S=>S.x).filter(S=>S>g+m))-m,M=Math.max(s,...p.map(S=>S.x).filter(S=>S<g-m).map(S=>S+m));for(const S of aA(_)){const x=n.measureText(S).width+3*l,k=Math.min(g,u-x,f-x);if(!(k<M||k+x<g)){d.push([S,_.what,k/devicePixelRatio]),u=k-oA*l;break}}}n.restore(),this.label(d)}label(t){const e=JSON.stringify(t.map(([n,s])=>[n,s]));e!==this.shown&&this.root.replaceChildren(...t.map(([n,s])=>U("span",{className:`event ${xc.includes(s)?"quiet":""}`},n))),this.shown=e,t.forEach(([,,n],s)=>this.root.children[s].style.left=`${n.toFixed(1)}px`)}}const co=420,He={left:58,right:10,top:8,bottom:34};function La(i){const t=i.square?co*.82:190,e=de("svg",{viewBox:`0 0 ${co} ${t}`,role:"img","aria-label":i.title,class:"drawing"}),n=g=>i.logX?Math.log10(g):g,[s,o]=[n(i.x[0]),n(i.x[1])],[r,a]=[co-He.left-He.right,t-He.top-He.bottom],l=g=>He.left+(n(g)-s)/(o-s)*r,c=g=>He.top+(1-(g-i.y[0])/(i.y[1]-i.y[0]))*a,h=ds(),u=`clip-${Math.random().toString(36).slice(2)}`,d=de("clipPath",{id:u});d.append(de("rect",{x:He.left,y:He.top,width:r,height:a})),e.append(d);for(const g of i.logX?uA(i.x):Da(i.x,6))e.append(de("line",{x1:l(g),x2:l(g),y1:He.top,y2:He.top+a,stroke:h.grid})),e.append(Gr(wd(g),l(g),He.top+a+14,"middle",h.soft));for(const g of Da(i.y,5))e.append(de("line",{x1:He.left,x2:co-He.right,y1:c(g),y2:c(g),stroke:h.grid})),e.append(Gr(wd(g),He.left-6,c(g)+4,"end",h.soft));e.append(Gr(i.xLabel,He.left+r/2,t-4,"middle",h.soft));const p=Gr(i.yLabel,0,0,"middle",h.soft);p.setAttribute("transform",`translate(9 ${He.top+a/2}) rotate(-90)`),e.append(p);const _=de("g",{"clip-path":`url(#${u})`});e.append(_),i.circle&&_.append(de("ellipse",{cx:l(0),cy:c(0),rx:l(1)-l(0),ry:c(0)-c(1),fill:"none",stroke:h.soft,"stroke-dasharray":"4 3"}));for(const g of i.marks??[]){const m=g.y===void 0?{x1:l(g.x??0),x2:l(g.x??0),y1:He.top,y2:He.top+a}:{y1:c(g.y),y2:c(g.y),x1:He.left,x2:co-He.right};_.append(de("line",{...m,stroke:h.push,"stroke-width":1.2,"stroke-dasharray":"5 3"}))}if((i.lines??[]).forEach((g,m)=>{const f=de("g",{id:`line-0-${m}-${u}`});f.append(cA(g,l,c)),_.append(f)}),i.read){const g={row:0,lines:[i.yLabel],left:He.left,right:co-He.right,top:He.top,bottom:He.top+a,x:i.x,y:i.y,logx:i.logX,unit:i.xLabel};e.classList.add("lines"),e.dataset.curves=JSON.stringify([g])}for(const g of i.points??[])_.append(hA(g.cross??!1,l(g.x),c(g.y),g.colour));return e}function Gr(i,t,e,n,s){const o=de("text",{x:t,y:e,"text-anchor":n,fill:s,"font-size":11.5});return o.textContent=i,o}function cA(i,t,e){let n="",s=!1;return i.x.forEach((o,r)=>{const a=i.y[r],l=Number.isFinite(o)&&Number.isFinite(a);l&&(n+=`${s?"L":"M"}${t(o).toFixed(1)} ${e(a).toFixed(1)}`),s=l}),de("path",{d:n,fill:"none",stroke:i.colour,"stroke-width":1.8,"stroke-dasharray":(i.dash??[]).join(" "),"stroke-linejoin":"round"})}function hA(i,t,e,n){if(!i)return de("circle",{cx:t,cy:e,r:4,fill:n});const s=4.5;return de("path",{d:`M${t-s} ${e-s}L${t+s} ${e+s}M${t-s} ${e+s}L${t+s} ${e-s}`,stroke:n,"stroke-width":1.8})}function Da([i,t],e){const n=(t-i)/e,s=10**Math.floor(Math.log10(n)),o=[1,2,5,10].map(a=>a*s).find(a=>a>=n)??n,r=[];for(let a=Math.ceil(i/o)*o;a<=t+o*1e-6;a+=o)r.push(Math.abs(a)<o*1e-6?0:a);return r}function uA([i,t]){const e=[];for(let n=Math.ceil(Math.log10(i));10**n<=t;n+=1)e.push(10**n);return e}function wd(i){return hs(String(+i.toPrecision(6)).replace("-","−"))}function nm(i){try{const t=i();return t.getItem(""),t}catch{const t=new Map;return{getItem:e=>t.get(e)??null,setItem:(e,n)=>void t.set(e,n),removeItem:e=>void t.delete(e)}}}const is=nm(()=>localStorage),Ui=nm(()=>sessionStorage);class bc{root;plot;marks=new lA;extent=[NaN,NaN];constructor(t,e,n,s,o,r=()=>1/0){const a=ds(),l=parseFloat(getComputedStyle(document.documentElement).fontSize)/16,c={stroke:a.soft,grid:{stroke:a.grid,width:1},ticks:{show:!1},font:`${11*l}px system-ui, sans-serif`},h=U("div.plot",{"aria-hidden":"true"},this.marks.root);h.style.setProperty("--height",`${s/16}rem`),this.root=U("figure.strip",{role:"group","aria-label":`${t} [${e}]`},U("figcaption",U("b",t),U("span",e)),h),this.plot=new xn({width:300,height:s,padding:[iA*l,18*l,0,0],cursor:{show:!1},legend:{show:!1},hooks:{draw:[u=>this.marks.draw(u,l)]},scales:{x:{time:!1},y:{range:()=>im(Math.max(this.extent[0],-r()),Math.min(this.extent[1],r()),o)}},axes:[{...c,size:20*l,values:(u,d)=>d.map(p=>p<0?"":hs(`${+p.toFixed(2)} s`)),space:46*l},{...c,size:46*l,splits:(u,d,p,_)=>fA(p,_,u.bbox.height/devicePixelRatio/(18*l)),values:(u,d)=>d.map(p=>hs(String(+p.toPrecision(4)).replace("-","−")))}],series:[{},...n.map(u=>({label:u.label,stroke:u.colour,width:(u.width??1.6)*l,dash:u.dash,points:{show:!1},spanGaps:!1,gaps:(d,p,_,g,m)=>[...m,...dA(d)].sort(([f],[M])=>f-M)}))]},[[],...n.map(()=>[])],h),new ResizeObserver(()=>this.fit(h)).observe(h)}fit(t){t.clientWidth>40&&this.plot.setSize({width:t.clientWidth,height:t.clientHeight})}show(t,e,n,s,o=e){const r=o.flat().filter(Number.isFinite);this.extent=r.length?[Math.min(...r),Math.max(...r)]:[NaN,NaN],this.plot.batch(()=>{this.plot.setData([t,...e],!1),this.plot.setScale("x",{min:n,max:s})})}}function dA(i){const{left:t,width:e}=i.bbox,n=2*devicePixelRatio;return C.traces.breaks.map(s=>s.map(o=>i.valToPos(o,"x",!0))).map(([s,o])=>[s-n/2,Math.max(o,s+n)]).filter(([s,o])=>s>t&&o<t+e)}function fA(i,t,e){let n=Math.max(1,Math.floor(e)),s=Da([i,t],n);for(;s.length<2&&n<12;)s=Da([i,t],n+=1);return s}function im(i,t,e){if(!Number.isFinite(i)||!Number.isFinite(t))return[-e,e];const n=(i+t)/2,s=Math.max((t-i)/2*1.1,e);return[n-s,n+s]}const wl=[0,2],pA=[3,20,30,60,3,12],Vs=matchMedia("(max-width: 40rem), (max-width: 62rem) and (max-height: 32rem)"),El=matchMedia("(max-width: 40rem)"),Ed=matchMedia("(min-width: 40.01rem)");class mA{constructor(t){this.seconds=t;for(const e of[Vs,Ed])e.addEventListener("change",()=>this.build())}root=U("section.charts");strips=[];legend=U("div.legend");slot=U("div.slot");large=null;build(){this.root.setAttribute("aria-label",F("charts"));const t=C.changed?.bodies??[],e=t.map(u=>({label:Ye(u),colour:rs(u),dash:Fh(u,t)})),n=is.getItem("curves")==="all";El.matches||(this.large=null),this.strips=$s.map((u,d)=>n||wl.includes(d)?new bc(`${Hs[d]}  ${Ye(u)}`,tm[d],e,104,pA[d],d?void 0:()=>Ja*(C.ceiling??1/0)):null),jt(this.legend,...t.map(u=>sm(u)));const s=Vs.matches?Ed.matches?wl.slice(0,1):wl:[],o=this.strips.filter((u,d)=>s.includes(d)).map(u=>u?.root),r=this.strips.map(u=>u?.root).filter(u=>!o.includes(u));this.strips.forEach((u,d)=>u&&this.enlargeable(u.root,d));const a=F(n?"fewerCurves":"moreCurves"),l=ne(El.matches?F(n?"fewer":"more"):a,()=>n?this.shown("first"):this.more(),"curves",{className:"quiet","aria-label":a,"aria-expanded":String(n)}),c=u=>u.some(Boolean)?U("div",{className:`strips${n?" all":""}`},...u):null,h=U("div.above",this.legend,l);jt(this.slot,...o.length?[h,c(o)]:[]),jt(this.root,o.length?null:h,c(r)),this.root.hidden=!this.root.childElementCount}more(){this.shown("all"),Vs.matches&&this.root.scrollIntoView()}shown(t){is.setItem("curves",t),zs(()=>this.build())}enlargeable(t,e){const n=U("button",{type:"button",className:"enlarge","data-key":`enlarge-${e}`},U("span",{"aria-hidden":"true"},"⤢"),U("span.hidden",F("large",{what:Ye($s[e])})));t.classList.toggle("large",this.large===e),n.setAttribute("aria-expanded",String(this.large===e)),t.querySelector("figcaption")?.append(n),t.addEventListener("click",()=>{El.matches&&(this.large=this.large===e?null:e,zs(()=>this.build()))})}draw(){const{t,x:e}=C.traces;if(!t.length||e.length!==C.changed?.bodies.length)return;const[n,s]=[this.seconds(),t.at(-1)],o=C.lain===null?s:Math.min(s,C.lain+.1*n),r=C.snapshot?.back?C.snapshot.t:Math.max(o,t[0]+n),a=r-n,l=Math.max(0,C.traces.since(a)-1),c=t.slice(l),h=C.traces.marks.findLast(g=>["stood","tilt"].includes(g.what)&&g.t<=r)?.t??-1/0,u=c.findIndex(g=>g>=Math.max(a,h)),d=C.snapshot?.x.map(g=>g[8]===1)??[],p=e.map((g,m)=>d.every(Boolean)||!d[m]),_=this.clipped(c,e[0]&&e.map(g=>g[0].slice(l)));this.strips.forEach((g,m)=>{const f=e.map(x=>va(x[m].slice(l))),M=u<0?f:f.filter((x,k)=>p[k]).map(x=>x.slice(u)),S=_&&m===0&&m===this.large?_:[a,r];g?.show(c,f,...S,M)})}clipped(t,e){const{ceiling:n}=C;if(n===null||!t.length)return null;const s=Math.max(...e.map(o=>o.findIndex(r=>Math.abs(r)>n)+1||1/0));return s<=t.length&&s>1?[t[0],t[s-1]]:null}}function va(i){return i.map(t=>Ja*t)}function sm(i){const t=Fh(i,C.changed?.bodies??[]).join(" "),e=de("line",{x1:0,x2:28,y1:5,y2:5,stroke:rs(i),"stroke-width":2.5,"stroke-dasharray":t}),n=de("svg",{width:28,height:10,"aria-hidden":"true"},e),s=Ye(`${i}Note`),o=i===C.changed?.bodies[0];return U("span.key",{title:s},n,o?F("robotIs",{body:Ye(i)}):Ye(i))}const gA=60,_A=5e3;class vA{since=-1;lean=0;actions=[];begin(t,e,n){[this.since,this.lean]=[t,e],this.actions=n.speed||n.rate?[[0,{kind:"Steer",...n}]]:[]}stop(){this.since=-1}note(t,e){this.since>=0&&this.actions.length<_A&&this.actions.push([Ro(e-this.since),t])}handIn(t,e,n,s,o){const r=Ro(s-this.since);if(this.since<0||!(r>0&&r<=gA)||!t.trim())return null;const a={kind:"upright hand-in",version:1,student:t.trim(),setup:e,step:n,lean:this.lean,seconds:r,actions:this.actions,claimed:o};return Ia({...a,seal:yA(Ia(a))})}}function Ro(i){return Number(i.toFixed(6))}const xA=["version","seed"];function Ia(i,t=""){return typeof i=="number"?xA.includes(t)?String(i):bA(i):Array.isArray(i)?`[${i.map(n=>Ia(n)).join(", ")}]`:i===null||typeof i!="object"?JSON.stringify(i):`{${Object.entries(i).sort(([n],[s])=>n<s?-1:1).map(([n,s])=>`${JSON.stringify(n)}: ${Ia(s,n)}`).join(", ")}}`}function bA(i){const[t,e]=i.toExponential().split("e").map((s,o)=>o?Number(s):s);if(i&&(e<-4||e>15))return`${t}e${e<0?"-":"+"}${String(Math.abs(e)).padStart(2,"0")}`;const n=Object.is(i,-0)?"-0":String(i);return n.includes(".")?n:`${n}.0`}function yA(i){const t=new TextEncoder().encode(i),e=Math.ceil((t.length+9)/64)*64,n=new Uint8Array(e);n.set(t),n[t.length]=128;const s=new DataView(n.buffer);s.setUint32(e-8,Math.floor(t.length/2**29)),s.setUint32(e-4,t.length<<3);const o=Td.slice(0,8).map(c=>Ad(Math.sqrt(c))),r=Td.map(c=>Ad(Math.cbrt(c))),a=new Int32Array(64),l=(c,h)=>c>>>h|c<<32-h;for(let c=0;c<e;c+=64){for(let M=0;M<16;M+=1)a[M]=s.getInt32(c+4*M);for(let M=16;M<64;M+=1){const[S,x]=[a[M-15],a[M-2]];a[M]=a[M-16]+(l(S,7)^l(S,18)^S>>>3)+a[M-7]+(l(x,17)^l(x,19)^x>>>10)}let[h,u,d,p,_,g,m,f]=o;for(let M=0;M<64;M+=1){const S=f+(l(_,6)^l(_,11)^l(_,25))+(_&g^~_&m)+r[M]+a[M]|0,x=(l(h,2)^l(h,13)^l(h,22))+(h&u^h&d^u&d)|0;[h,u,d,p,_,g,m,f]=[S+x|0,h,u,d,p+S|0,_,g,m]}[h,u,d,p,_,g,m,f].forEach((M,S)=>o[S]=o[S]+M|0)}return o.map(c=>(c>>>0).toString(16).padStart(8,"0")).join("")}const Td=Array.from({length:312},(i,t)=>t).filter(i=>i>1&&![2,3,5,7,11,13,17].some(t=>i%t===0&&i>t));function Ad(i){return(i-Math.floor(i))*2**32|0}const Rd=1e-9,MA=1-1e-9,[SA,wA]=[.3,.001],[EA,TA]=[3e3,160],xa=(i,t)=>Array.from({length:i},()=>new Float64Array(t));function yc(i,t){const e=xa(i.length,t[0].length);for(let n=0;n<i.length;n+=1){const[s,o]=[i[n],e[n]];for(let r=0;r<s.length;r+=1){const[a,l]=[s[r],t[r]];if(a)for(let c=0;c<o.length;c+=1)o[c]+=a*l[c]}}return e}const om=i=>Math.max(...i.map(t=>t.reduce((e,n)=>e+Math.abs(n),0)));function Cd({A:i,B:t},e){const n=[...i.map((a,l)=>Float64Array.from([...a,...t[l]],c=>c*e)),...xa(2,8)],s=Math.max(0,Math.ceil(Math.log2(om(n)+1e-300))+2);let[o,r]=[xa(8,8),xa(8,8)];for(let a=0;a<8;a+=1)r[a][a]=1;for(let a=1;a<20;a+=1)o=o.map((l,c)=>l.map((h,u)=>h+r[c][u])),r=yc(r,n).map(l=>l.map(c=>c/a/2**s));for(let a=0;a<s;a+=1)o=yc(o,o);return o.slice(0,6)}function Tl(i,t){const e=Math.floor(i/t+Rd),n=i-e*t;return[e,n>Rd*t?n:0]}function Pd(i,t,e,n=0,s=!1){const o=i.period,[r,a]=Tl(i.dead+n,o),l=Tl(i.dead,o)[0],c=S=>{const[x,k]=[Cd(i,Math.min(S,a)),Cd(i,Math.max(S-a,0))],P=(A,I,E)=>A.map(b=>b.reduce((R,H,O)=>R+H*(O<6?I[O]:E[O-6]),0));return(A,I,E)=>P(k,P(x,A,E),I)},h=i.delays.map(S=>{const[x,k]=Tl(S,o);return k?{count:x+1,enters:c(o-k)}:{count:x,enters:null}}),u=c(o),[d,p]=[r+(a?1:0),new Float64Array(6)],_=6+h.reduce((S,x)=>S+x.count,0),g=_+2*d,m=g+t.start.length+2*l,f=S=>{const x=new Float64Array(m),k=(X,j)=>i.C[j].reduce((Q,at,lt)=>Q+at*X[lt],0);let P=6;const A=Float64Array.from(h,({count:X},j)=>(P+=X,X?S[P-1]:k(S,j))),[I,E]=[S.slice(g,g+t.start.length),new Float64Array(8)];t.command(I,A,p,E,e);const b=s?(E[0]+E[1])/2:0,R=[E[0]-b,E[1]-b],H=X=>X?[...S.slice(_+2*X-2,_+2*X)]:R,[O,q]=[H(r),a?H(r+1):[0,0]];x.set(u(S,O,q)),P=6,h.forEach(({count:X,enters:j},Q)=>{X&&(x.set(S.subarray(P,P+X-1),P+1),x[P]=k(j?j(S,O,q):S,Q)),P+=X}),d&&x.set([...R,...S.subarray(_,g-2)],_);const $=g+t.start.length;return t.update(I,A,p,E,e,l?S.slice(m-2):E.slice(0,2)),x.set(I,g),l&&x.set([...E.subarray(0,2),...S.subarray($,m-2)],$),x},M=Array.from({length:m},(S,x)=>f(new Float64Array(m).fill(1,x,x+1)));return Array.from({length:m},(S,x)=>Float64Array.from(M,k=>k[x]))}function Ld(i){let[t,e]=[i,0];for(let n=0;n<34;n+=1){const s=om(t);if(e+=Math.log(s),!(s>0)||e<-1)return!0;if(e>60)return!1;t=t.map(o=>o.map(r=>r/s)),t=yc(t,t),e*=2}return!1}function Dd(i){const t=i.length,e=i.map(a=>Float64Array.from(a));for(let a=1;a<t-1;a+=1){let l=a;for(let c=a+1;c<t;c+=1)Math.abs(e[c][a-1])>Math.abs(e[l][a-1])&&(l=c);if(e[l][a-1]){[e[a],e[l]]=[e[l],e[a]];for(const c of e)[c[a],c[l]]=[c[l],c[a]];for(let c=a+1;c<t;c+=1){const h=e[c][a-1]/e[a][a-1];if(h){for(let u=0;u<t;u+=1)e[c][u]-=h*e[a][u];for(const u of e)u[a]+=h*u[c]}}}}const n=i.map(()=>new Float64Array(t)),s=[];let[o,r]=[t-1,0];for(;o>=0;){let a=o;const l=u=>Math.hypot(e[u][u-1],n[u][u-1])<=Number.EPSILON*(Math.hypot(e[u][u],n[u][u])+Math.hypot(e[u-1][u-1],n[u-1][u-1]));for(;a>0&&!l(a);)a-=1;if(a===o){s.push([e[o][o],n[o][o]]),[o,r]=[o-1,0];continue}const[c,h]=r%11===10?[Math.abs(e[o][o-1])+e[o][o],n[o][o]]:AA(e,n,o);if(RA(e,n,a,o,c,h),r+=1,r>300)return s}return s}function AA(i,t,e){const n=(p,_)=>[i[p][_],t[p][_]],[s,o,r,a]=[n(e-1,e-1),n(e-1,e),n(e,e-1),n(e,e)],l=[(s[0]-a[0])/2,(s[1]-a[1])/2],c=PA(Id(Al(l,l),Al(o,r))),h=l[0]*c[0]+l[1]*c[1]<0?-1:1,u=Id(l,[h*c[0],h*c[1]]),d=u[0]||u[1]?CA(Al(o,r),u):u;return[a[0]-d[0],a[1]-d[1]]}function RA(i,t,e,n,s,o){for(let a=e;a<=n;a+=1)[i[a][a],t[a][a]]=[i[a][a]-s,t[a][a]-o];const r=[];for(let a=e;a<n;a+=1){const[l,c,h,u]=[i[a][a],t[a][a],i[a+1][a],t[a+1][a]],d=Math.hypot(l,c,h,u)||1,[p,_,g,m]=[l/d,c/d,h/d,u/d];r.push([p,_,g,m]);for(let f=a;f<=n;f+=1){const[M,S,x,k]=[i[a][f],t[a][f],i[a+1][f],t[a+1][f]];i[a][f]=p*M+_*S+g*x+m*k,t[a][f]=p*S-_*M+g*k-m*x,i[a+1][f]=p*x-_*k-g*M+m*S,t[a+1][f]=p*k+_*x-g*S-m*M}}r.forEach(([a,l,c,h],u)=>{const d=e+u;for(let p=e;p<=Math.min(d+1,n);p+=1){const[_,g,m,f]=[i[p][d],t[p][d],i[p][d+1],t[p][d+1]];i[p][d]=a*_-l*g+c*m-h*f,t[p][d]=a*g+l*_+c*f+h*m,i[p][d+1]=a*m+l*f-c*_-h*g,t[p][d+1]=a*f-l*m-c*g+h*_}});for(let a=e;a<=n;a+=1)[i[a][a],t[a][a]]=[i[a][a]+s,t[a][a]+o]}const Id=(i,t)=>[i[0]+t[0],i[1]+t[1]],Al=(i,t)=>[i[0]*t[0]-i[1]*t[1],i[0]*t[1]+i[1]*t[0]],CA=(i,t)=>[(i[0]*t[0]+i[1]*t[1])/(t[0]**2+t[1]**2),(i[1]*t[0]-i[0]*t[1])/(t[0]**2+t[1]**2)];function PA([i,t]){const e=Math.hypot(i,t);return[Math.sqrt(Math.max(e+i,0)/2),(t<0?-1:1)*Math.sqrt(Math.max(e-i,0)/2)]}function Nd(i,t,e){return t.slice(1).flatMap((n,s)=>{if(e[s]<0==e[s+1]<0)return[];let[o,r]=[t[s],t[s+1]];for(let a=0;a<60;a+=1){const l=(o+r)/2;i(l)<0==e[s]<0?o=l:r=l}return[(o+r)/2]})}const rm=(i,t,e)=>Array.from({length:e},(n,s)=>i*(t/i)**(s/(e-1))),am=i=>rm(.05,Math.PI/i,TA).filter((t,e)=>e%2===0);function LA(i,t){let[e,n]=[0,0];for(;i(n);){if(e>t)return 1/0;[e,n]=[n,n+wA]}for(let s=0;n&&s<12;s+=1){const o=(e+n)/2;i(o)?e=o:n=o}return e}const Ud=i=>Number.isFinite(i)?i:null;function DA(i,t,e){const[n,s]=[!1,!0].map(A=>Pd(i,t,e,0,A)),o=Dd(n).sort((A,I)=>Math.hypot(...I)-Math.hypot(...A)),r=Dd(s),a=A=>{const I=[Math.cos(A*i.period),Math.sin(A*i.period)];let[E,b]=[1,0];for(let R=0;R<o.length;R+=1){const[H,O,q,$]=[I[0]-o[R][0],I[1]-o[R][1],I[0]-r[R][0],I[1]-r[R][1]],[X,j,Q]=[q*q+$*$,H*q+O*$,O*q-H*$];[E,b]=[(E*j-b*Q)/X,(E*Q+b*j)/X]}return[E-1,b]},l=Math.PI/i.period,c=am(i.period),h=c.map(a),u={stable:Math.hypot(...o[0])<MA,poles:o,gain_low:1,gain_high:1,phase:0,delay:0,L:[c,h.map(([A])=>A),h.map(([,A])=>A)]};if(!u.stable)return u;const d=Array.from({length:300},(A,I)=>(I+1)*l/300),p=[...rm(Math.min(.001,l/1e6),l,EA),...d].sort((A,I)=>A-I),_=p.map(a),m=[0,l,...Nd(A=>a(A)[1],p,_.map(([,A])=>A))].map(A=>a(A)[0]).filter(A=>A<0&&A>-1e6).map(A=>-1/A).sort((A,I)=>A-I),f=A=>A.find(I=>!Ld(s.map((E,b)=>E.map((R,H)=>R+(I+(I-1)/1e3)*(n[b][H]-R))))),M=([A,I])=>A*A+I*I-1,S=Nd(A=>M(a(A)),p,_.map(M)),x=S.map(A=>{const[I,E]=a(A);return(Math.atan2(E,I)+3*Math.PI)%(2*Math.PI)}),k=x.map((A,I)=>A/S[I]),P=LA(A=>Ld(Pd(i,t,e,A)),Math.min(SA,...k));return{...u,gain_low:f(m.filter(A=>A<1).reverse())??0,gain_high:f(m.filter(A=>A>1))??null,phase:Ud(Math.min(...x.map(A=>Math.min(A,2*Math.PI-A)))),delay:Ud(Math.min(P,...k))}}const[IA,NA,UA,kA]=[.05,.4,1,.5];class zh{best=0;run=0;effort=0;given=0;impulse=0;lasted=0;calm=0;before=0;push(){this.given||([this.impulse,this.lasted,this.before]=[0,0,this.effort]),this.given+=1,this.calm=0}exchanged(){this.given+=this.given?1:0,this.impulse=0}anew(t){return Object.assign(new zh,{best:this.best,given:t?1:0})}watch(t,e,n,s,o,r){if(this.effort+=(o[0]**2+o[1]**2)*t,e)this.impulse+=Math.abs(e)*t,this.lasted+=t,this.calm=0;else if(this.given&&(this.calm=Math.abs(n)<IA&&Math.abs(s)<NA?this.calm+t:0,r||this.calm>=UA))return this.ended(r);return null}ended(t){const e=this.given===1;return this.given=0,!this.impulse||this.lasted>kA&&!t?null:(e&&!t&&(this.run=Math.max(this.run,this.impulse)),this.best=Math.max(this.best,this.run),{kind:"Recovered",impulse:this.impulse,effort:this.effort-this.before,best:this.best,fell:t,single:e})}}function FA(i){const t=Math.round(i);return Math.abs(i%1)===.5&&t%2?t-1:t}const OA=(i,t,e,n,s,o,r,a,l)=>{const c=Math.abs(i),h=n<c?i:0,u=Math.abs(t),d=n<u?t:0,p=Math.abs(h),_=p<r?p:r,g=Math.abs(d),m=g<r?g:r,f=_+m,M=a*f,S=r-M,x=e<S?e:S,k=-x,P=x<h?x:h,A=h<k?k:P,I=-s,E=I<0?s:1,b=A/E,H=Math.trunc(b)*E,O=I<0?H:A,q=x<d?x:d,$=d<k?k:q,X=$/E,Q=Math.trunc(X)*E,at=I<0?Q:$,lt=-o,gt=o<O?o:O,xt=O<lt?lt:gt,mt=O-xt,ot=lt<0?mt:O,ut=o<at?o:at,_t=at<lt?lt:ut,ht=at-_t,Nt=lt<0?ht:at,zt=p<g?g:p,Ut=x<zt?1:0;l[0]=ot,l[1]=Nt,l[2]=S,l[3]=Ut},BA=(i,t,e,n,s,o,r,a,l)=>{const c=Math.abs(i),h=n<c?i:0,u=Math.abs(t),d=n<u?t:0,p=Math.abs(h),_=p<r?p:r,g=Math.abs(d),m=g<r?g:r,f=_+m,M=a*f,S=r-M,x=-e,k=e<h?e:h,P=h<x?x:k,A=-s,I=A<0?s:1,E=P/I,R=Math.trunc(E)*I,H=A<0?R:P,O=e<d?e:d,q=d<x?x:O,$=q/I,j=Math.trunc($)*I,Q=A<0?j:q,at=-o,lt=o<H?o:H,gt=H<at?at:lt,xt=H-gt,mt=at<0?xt:H,ot=o<Q?o:Q,ut=Q<at?at:ot,_t=Q-ut,ht=at<0?_t:Q,Nt=p<g?g:p,zt=e<Nt?1:0;l[0]=mt,l[1]=ht,l[2]=S,l[3]=zt},zA=(i,t,e,n,s)=>{const o=i*e,r=t*n;s[0]=o,s[1]=r},HA=(i,t,e,n)=>{const s=t-e,o=t+e,r=o<i?o:i,a=i<s?s:r;n[0]=a},VA=(i,t,e,n,{quantum:s,noise:o,bias_walk:r,range:a,gain:l,offset:c},h)=>{const u=r*n,d=t+u,g=l*i+c+d,m=o*e,f=g+m,M=-s,S=M<0?s:1,x=f/S,P=FA(x)*S,A=M<0?P:f,I=-a,E=a<A?a:A,b=A<I?I:E;h[0]=b,h[1]=d},GA=(i,t,{tilt:e,b1:n,b2:s,a1:o,a2:r},a)=>{const l=s*i,c=r*i,h=l+c,u=n*i,d=o*i,_=u+d+h,g=e*t,m=i+g;a[0]=m,a[1]=_,a[2]=h},WA=(i,t,e,n,{tilt:s,b0:o,b1:r,b2:a,a1:l,a2:c},h)=>{const d=o*i+e,p=r*i,_=l*d,m=p+_+n,f=a*i,M=c*d,S=f+M,x=s*t,k=d+x;h[0]=k,h[1]=m,h[2]=S},$A=(i,t,e,n,s,o,r,{time_constant:a,spell:l},c)=>{const h=s*t,u=o*e,d=h+u,p=r*a,_=d/p,g=n-_,m=l*g,f=i+m;c[0]=f},qA=1.4,XA=.8,kd=1e-9,[jA,YA,KA,ZA]=[0,2,4,6];function JA(i,t,e,n){let s=0,o=0;for(const r of i){const a=r.start-kd<=t&&t<r.start+r.duration-kd;s+=a?r.force:0,o+=(a?r.force:0)*r.height}n[0]=s,n[1]=s?o/s:0,n[2]=e}function Fd(i,t){const[e,n,s,o]=[i>>>16,i&65535,t>>>16,t&65535],r=e*o+Math.floor(n*o/65536),a=n*s+r%65536;return e*s+Math.floor(r/65536)+Math.floor(a/65536)}function lm([i,t,e,n],[s,o]){for(let r=0;r<10;r+=1)[i,t,e,n]=[(Fd(3449720151,e)^t^s)>>>0,Math.imul(3449720151,e)>>>0,(Fd(3528531795,i)^n^o)>>>0,Math.imul(3528531795,i)>>>0],s=s+2654435769>>>0,o=o+3144134277>>>0;return[i,t,e,n]}function QA(i,t,e,n){const s=lm([i,0,0,t+(e>>2)],[n,0]),[o,r]=e&2?s.slice(2):s,a=Math.sqrt(-2*Math.log((o+.5)/2**32)),l=Math.PI*(r/2**31-1);return a*(e&1?Math.sin(l):Math.cos(l))}function tR(i,t){const{from:e,every:n,b0:s,sources:o}=i,{x:r,ideal:a}=t,l=new Float64Array(3);if(s!==void 0)return GA(r[1],r[5],i,l),()=>(t.steps&&WA(r[1],r[5],l[1],l[2],i,l),l[0]);if(o){l[0]=r[0];const c=o.map(h=>new cm(h,t.seed,t));return()=>{if(c[0].count>t.steps)return l[0];const[h,u]=[Math.cos(l[0]),Math.sin(l[0])],[d,p,_]=c.map(g=>g.read());return t.steps&&t.steps%n===0&&$A(l[0],h,u,d,p,_,t.body.gravity,i,l),l[0]}}return()=>e<0?t.voltage:a[e]}class cm{constructor(t,e,n){this.sensor=t,this.sense=tR(t,n);const s=this.sense();this.seed=e,this.count=0,this.held=0,this.touch=s,this.line=new Float64Array(t.delay+1).fill(s),this.bias=t.bias*this.normal(KA),this.out=new Float64Array(2)}normal(t){return QA(this.count,t,this.sensor.kind,this.seed)}read(){const{play:t,delay:e,every:n}=this.sensor;let s=this.sense();return t&&(HA(this.touch,s,t,this.out),this.touch=s=this.out[0]),this.line[this.count%(e+1)]=s,this.count%n===0&&(this.held=this.fresh(this.line[(this.count+1)%(e+1)])),this.count+=1,this.held}fresh(t){const{bias_walk:e,noise:n,walks:s}=this.sensor,o=e&&this.count%s===0?this.normal(YA):0;return VA(t,this.bias,n?this.normal(jA):0,o,this.sensor,this.out),this.bias=this.out[1],this.out[0]}}class eR{constructor(t,e,n,s){this.body=t,this.control=e,this.x=Float64Array.from(n),this.steps=0,this.z=Float64Array.from(e.law?.start??[]),this.before=Float64Array.from(this.z),this.y=new Float64Array(e.reads.length),this.u=new Float64Array(8),this.sent=new Float64Array(2),this.applied=new Float64Array(2),this.driven=new Float64Array(2),this.out=new Float64Array(4),this.w=new Float64Array(3),this.ideal=new Float64Array(7),this.stopped=!1,this.twist=0,t.motion.read(this.x,this.applied,this.w,this.ideal),this.ideal[6]=this.x[0],this.voltage=t.kit?.voltage??1/0,this.waiting=[],this.latest=[0,0],this.arrived=[0,0],this.seed=s,this.channels=(t.kit?.sensors??[]).map(o=>new cm(o,s,this)),this.values=new Float64Array(6+(t.kit?this.channels.length:7)),this.sense()}get t(){return this.steps*this.body.period}get fallen(){return Math.abs(this.x[0])>qA}sense(){this.values.set(this.x),this.body.kit||this.values.set(this.ideal,6),this.channels.forEach((t,e)=>this.values[6+e]=t.read())}step(t,e){const{law:n,reads:s,stride:o,gains:r=[]}=this.control;this.before.set(this.z);for(let a=0;a<s.length;a+=1)this.y[a]=this.values[s[a]];n?.command(this.z,this.y,t,this.u,r),this.stopped||=Math.abs(this.x[0])>XA,this.stopped?this.sent.fill(0):this.sent.set(this.u.subarray(0,2));for(let a=0;a<o;a+=1)e(this.t,this.w),this.move();n?.update(this.z,this.y,t,this.u,r,this.applied)}move(){const{motion:t,kit:e}=this.body;e?this.drive(e):this.applied.set(this.sent),zA(this.applied[0],this.applied[1],e?.left??1,e?.right??1,this.driven),this.driven[0]+=this.twist,this.driven[1]-=this.twist,t.step(this.x,this.driven,this.w,this.ideal),this.ideal[6]=this.x[0],this.steps+=1,this.sense()}drive(t){const[e,n]=this.delayed(t),[s,o]=[t.limit??1/0,t.voltage??1/0];(t.volts?OA:BA)(e,n,s,t.dead_zone,t.quantum,t.drop,o,t.sag,this.out),[this.applied[0],this.applied[1],this.voltage]=this.out}delayed(t){const[e,n]=this.sent;if(e!==this.latest[0]||n!==this.latest[1]){const[s]=lm([this.steps,0,0,ZA],[this.seed,0]),o=Math.floor(s*(t.jitter+1)/2**32);this.waiting.push([this.steps+t.delay+o,e,n]),this.latest=[e,n]}for(;this.waiting.length&&this.waiting[0][0]<=this.steps;)this.arrived=this.waiting.splice(0,1)[0].slice(1);return this.arrived}}function nR(i){const t=new Float64Array(6);let e=0;const n=(s,o,r,a)=>{const l=i.turn*s[4],[c,h]=[Math.cos(s[0]),Math.sin(s[0])],u=i.radius*e+i.gravity*Math.sin(r[2])*Math.cos(s[4]),d=i.gravity*Math.cos(r[2]);a.set([s[2]-l-s[0],s[2]+l-s[0],s[1],s[4],u*c-d*h,u*h+d*c])};return{step(s,o,r,a){const l=[r[0],r[0]*r[1],r[2]];for(let c=0;c<6;c+=1){let h=0;for(let u=0;u<6;u+=1)h+=i.A[c][u]*s[u];t[c]=h+i.B[c][0]*o[0]+i.B[c][1]*o[1]+i.E[c][0]*l[0]+i.E[c][1]*l[1]+i.E[c][2]*l[2]}e=(t[3]-s[3])/i.period,s.set(t),n(s,o,r,a)},read:n}}{const i=new WeakMap;let t=()=>{};const e=a=>[...a.getAttribute("d").matchAll(/[ML] ?(-?[\d.]+) (-?[\d.]+)/g)].map(([,l,c])=>[+l,+c]),n=a=>{const l=JSON.parse(a.dataset.curves);for(const h of l){const u=h.lines.map((d,p)=>a.querySelector(`[id^=line-${h.row}-${p}-] path`));h.paths=u.map(d=>d?e(d):[])}const c=a.appendChild(document.createElementNS(a.namespaceURI,"line"));return i.set(a,{panels:l,rule:c,out:a.nextElementSibling}),i.get(a)},s=([a,l],c,h)=>c?a*(l/a)**h:a+h*(l-a),o=(a,l)=>{const{panels:c,rule:h,out:u}=i.get(a)??n(a),d=new Intl.NumberFormat(a.closest("[lang]")?.lang??document.documentElement.lang,{maximumSignificantDigits:3,useGrouping:!1}),p=I=>d.format(I).replace("-","−"),_=a.getBoundingClientRect(),g=(l.clientX-_.left)/_.width*a.viewBox.baseVal.width,{left:m,right:f,top:M,x:S,logx:x,unit:k}=c[0];if(g<m||g>f)return;const P=[];for(const{label:I,lines:E,paths:b,y:R,logy:H,top:O,bottom:q}of c)for(const[$,X]of b.entries()){const j=X.findIndex(_t=>_t[0]>=g);if(j<0||X[0][0]>g+1)continue;const[[Q,at],[lt,gt]]=[X[Math.max(j-1,0)],X[j]],xt=lt>Q?at+(g-Q)/(lt-Q)*(gt-at):gt,mt=(q-xt)/(q-O),ut=(mt>1.01?"> ":mt<-.01?"< ":"")+p(s(R,H,Math.min(Math.max(mt,0),1)));P.push(`${c.length>1?`${I}, `:""}${E[$]}: ${ut}`)}const A={class:"rule",x1:g,x2:g,y1:M,y2:c[c.length-1].bottom};for(const[I,E]of Object.entries(A))h.setAttribute(I,E);u.textContent=[`${k} ${p(s(S,x,(g-m)/(f-m)))}`,...P].join("   "),t=()=>{h.setAttribute("class","hidden"),u.textContent=""}},r=a=>{t(),t=()=>{};const l=a.composedPath()[0].closest?.("svg.lines");l&&o(l,a)};for(const a of["pointerdown","pointermove"])document.addEventListener(a,r);document.documentElement.addEventListener("pointerleave",r)}function hm({verdict:i,level:t,title:e,lead:n,numbers:s}){return U("div.first",i&&U("p",{className:`badge ${t}`},i),e&&U("p",U("b",e)),...n.map(o=>U("p.note",o)),s.length>0&&U("dl.facts",...s.flatMap(([o,r])=>[U("dt",o),U("dd",r)])))}class um{constructor(t=()=>({})){this.acts=t}host=U("div.page");root=this.host.attachShadow({mode:"open"});shown=null;show(t){if(t===this.shown&&this.host.lang===Oo())return this.host;const e=t===this.shown?[...this.root.querySelectorAll("details")].map(s=>s.open):[];this.shown=t,this.host.lang=Oo(),this.host.replaceChildren(),this.root.innerHTML=Gi(t.html),this.root.querySelectorAll("details").forEach((s,o)=>s.open=e[o]??!1);const n=this.acts(t.job);for(const s of this.root.querySelectorAll("[data-verb]")){const{verb:o=""}=s.dataset;if(!Object.hasOwn(n,o))continue;const[r,a]=n[o];s.append(Object.assign(document.createElement("slot"),{name:o})),this.host.append(ne(r,a,`next-${o}`,{slot:o}))}return this.host}}const Od=1e-6,iR=11;function sR({stable:i,poles:t}){return!i&&t.length>0}function dm(){return[F("designing"),C.setup.controller==="robust"&&F("robustTakes")].filter(Boolean).join(" ")}function fm(){const i=C.analysed;if(C.off)return[U("p.note",F("noLoop"))];if(!i)return[U("p.note",dm())];const t=Qe?.facts.robots[C.setup.robot]?.delay_own??0,{delay:e}=C.setup,n=Qe&&e>=0&&Math.abs(e-t)>5e-4,s=U("p.note",F("delayOwn",{own:fe(1e3*t,2),now:fe(1e3*e,2)}));return[hm(Gi(i.heads)),...n?[s]:[]]}function oR(i,t){const e=Za().loopSaid,n=Math.hypot(...i.poles[0]);if(n>1+Od){const k=Wr(t*Math.log(2)/Math.log(n),2);return{verdict:e.unstable,level:"bad",title:ni(e.doubles,{time:k}),lead:[],numbers:[]}}if(n>1-Od)return{verdict:e.free,level:"warn",title:e.unheld,lead:[],numbers:[]};const s=e.both,o=i.gain_high??1/0,r=i.delay===null?1/0:Math.floor(1e4*i.delay)/1e4,a=[[(i.delay??1/0)/(YT*t),""],[(o-1)/md,ni(e.stronger,{change:$r(o-1),place:s})],[(1-i.gain_low)/md,ni(e.weaker,{change:$r(1-i.gain_low),place:s})]],[l,c]=a.reduce((k,P)=>P[0]<k[0]?P:k),h=String(Math.ceil(100*i.gain_low)),u=o<iR?ni(e.range,{low:h,high:String(Math.floor(100*o))}):ni(e.atLeast,{low:h}),d=i.phase===null?1/0:180*i.phase/Math.PI,p=[[(o-1)/(_d-1),e.unlessStronger,$r(o-1)],[(1-i.gain_low)/(1-gd),e.unlessWeaker,$r(1-i.gain_low)],[(i.delay??1/0)/t,e.unlessLater,Wr(r,3)],[d/vd,e.withPhase,`${fe(d,2)}°`]],[_,g,m]=p.reduce((k,P)=>P[0]<k[0]?P:k),f=_>=1,[M,S]=l<1?[e.thin,"warn"]:f?[e.usual,"good"]:[e.small,"warn"],x=ni(e.range,{low:100*gd,high:100*_d});return{verdict:M,level:S,title:ni(f?e.roomy:g,{controller:"u = −K x",robot:C.setup.robot,size:m,place:s}),lead:l<1&&c?[c]:[],numbers:[[`${u} %`,ni(e.strength,{usual:`${x} %`})],[Wr(r,3),ni(e.delay,{place:s,usual:Wr(t,3)})],[d<1/0?`${fe(d,2)}°`:"∞",ni(e.phase,{usual:`${vd}°`})]]}}function Wr(i,t){return i<.1?`${fe(1e3*i,t)} ms`:`${fe(i,t)} s`}function $r(i){return`${fe(100*i,2)} %`}const Qe=globalThis.uprightExport??null,Na=["nonlinear","linear"],Mc="off",rR=200,aR=.02,Bd=.3,lR=3,cR=1.5,hR=60,zd=.02,uR=2;function pm({facts:i}){const t=Object.entries(i.robots).map(([n,{controllers:s,laden:o}])=>[n,{controllers:[...Object.keys(s),Mc],load:o?.look??null}]),e=Hi.robot in i.robots?Hi.robot:i.catalogue.robots[0].name;return{usual:{...Hi,robot:e,bodies:[...Na]},robots:Object.fromEntries(t),kits:[],parameters:[],bodies:Na,keys:["gains","slope","noise","delay","seed","payload","payload_height","bodies"]}}class dR{loop;offset;constructor(t,e,n,s,o,r){this.offset=[0,0,o[2],0,o[4],0];const a=[o[0],o[1],0,o[3],0,o[5]];this.loop=new eR({motion:e,period:t.period,gravity:t.gravity,kit:n},s,a,r)}state(){const t=Array.from(this.loop.x,(e,n)=>e+this.offset[n]);return this.loop.fallen&&([t[0],t[1],t[3],t[5]]=[Math.sign(t[0])*cR,0,0,0]),t}row(){return[...this.state(),...this.loop.applied,this.loop.fallen?1:0]}shifted(t){return[t[2]+this.offset[2],t[4]+this.offset[4]]}estimate(t){const{before:e,y:n}=this.loop,[s,o]=[t.S??[],t.Sy??[]],r=(a,l)=>a.reduce((c,h,u)=>c+h*l[u],0);return s.map((a,l)=>r(a,e)+r(o[l],n)+this.offset[l])}}class fR{constructor(t){this.data=t,this.setup=pm(t).usual,C.send=e=>this.take(e),C.hear(t.facts.welcome),C.hear(t.facts.catalogue),this.changeTo(this.setup),window.setInterval(()=>this.tick(),16)}setup;lanes=[];periods=0;owed=0;paused=!1;speed=1;back=0;n=0;wall=performance.now();target=new Float64Array(6);steer={speed:0,rate:0};hand={force:0,start:-1,duration:1/0,height:0};active=[];pulled={until:-1,force:0};acting=new Float64Array(3);pulling=0;kept=[];score=new zh;recorder=new vA;run={rows:0,peak:0,travel:0,from:0};thinking=0;spent=0;get facts(){const t=this.data.facts.robots[this.setup.robot];return this.setup.payload&&t.laden?{...t,...t.laden}:t}get controller(){return this.facts.controllers[this.setup.controller]??null}get t(){return this.periods*this.facts.every}take(t){switch(C.note(t,this.t),t.kind){case"Change":this.changeTo(t.setup);break;case"Drag":t.force&&!this.hand.force&&this.score.push(),this.hand={...this.hand,force:t.force,height:t.height};break;case"Strike":this.strike(t.what,t.size);break;case"Steer":this.steer={speed:t.speed,rate:t.rate};break;case"Play":[this.paused,this.speed,this.back]=[t.paused,t.speed,t.paused?this.back:0];break;case"Step":this.stepped(t.periods);break;case"Scrub":[this.paused,this.back]=[!0,t.back];break;case"StandUp":this.stand(t.pitch);break;case"Save":t.what==="csv"?this.keepTraces():this.handIn(t.name);break;default:return}(t.kind==="Drag"||t.kind==="Strike"||t.kind==="Steer")&&this.recorder.note(t,this.t),this.show()}changeTo(t){const e=this.data.facts.robots,n=Object.hasOwn(e,t.robot)?t.robot:this.setup.robot,s=e[n].controllers,r=Object.hasOwn(s,t.controller)||t.controller===Mc?t.controller:Object.keys(s)[0],a=t.gains.length===6?t.gains:s.gains?.gains??[],l=Na.filter((M,S)=>S===0||t.bodies.includes(M)),c=t.payload?e[n].laden?.look:void 0,{payload:h,payload_height:u}=c??Hi,[d,p]=[this.setup,this.lanes.length>0&&n===this.setup.robot];this.setup={...t,robot:n,controller:r,gains:a,bodies:l,payload:h,payload_height:u},this.recorder.stop();const _=p&&l.length===this.lanes.length,g=_&&r===d.controller&&t.noise===d.noise&&t.delay===d.delay&&h===d.payload,m=p&&!this.lanes[0].loop.fallen?this.lanes[0].state():[0,0,0,0,0,0],f=l.map((M,S)=>_&&!this.lanes[S].loop.fallen?this.lanes[S].state():m);if(JSON.stringify({...d,slope:0})!==JSON.stringify({...this.setup,slope:0})&&this.score.exchanged(),g)for(const M of this.lanes)M.loop.control.gains=a;else this.build(f);_||(this.kept=[]),p||this.traced(),this.said(!p||h!==d.payload)}said(t){const{facts:e,controller:n,setup:s}=this,o={delay:this.delay(),dead_zone:e.kit?.dead_zone??0,voltage:e.kit?.voltage??-1},r={kind:"Changed",setup:s,look:e.look,bodies:s.bodies,period:e.every,kit:o,busy:!1};if(C.hear(r),t&&C.hear(e.equations),C.analysed=null,window.clearTimeout(this.thinking),C.hear(em),!n)return;const{plant:a}=n;n.analysed?C.hear({...n.analysed,L:[am(e.every),...n.analysed.L]}):a&&(this.thinking=window.setTimeout(()=>{const l=DA(a,this.data.laws[s.robot][s.controller],s.gains),{stable:c,poles:h,L:u}=l;C.hear({kind:"Analysed",stable:c,heads:UT(()=>oR(l,a.period)),gain:[s.gains],poles:h,L:u})},rR))}traced(){C.traces.reset(this.setup.bodies.length),this.kept=[],this.periods=0}delay(){return this.setup.delay<0?this.facts.delay_own:this.setup.delay}kit(){const{kit:t,period:e}=this.facts;if(!t)return null;const n=this.setup.noise,s=t.sensors.map(o=>({...o,quantum:o.quantum*n,noise:o.noise*n,bias:o.bias*n}));return{...t,sensors:s,delay:Math.round(this.delay()/e)}}build(t){const{facts:e,setup:n,controller:s}=this,o=s?this.data.laws[n.robot][n.controller]:null,r=s?.stride??Math.round(e.every/e.period),a={law:o,reads:s?.reads??[],stride:r,gains:n.gains},l=n.bodies.map(h=>h===Na[0]?this.data[n.payload?"laden":"motions"][n.robot]:nR(e.linear)),c=this.kit();this.lanes=l.map((h,u)=>new dR(e,h,c,{...a},t[u]??[0,0,0,0,0,0],n.seed)),this.target.fill(0),[this.owed,this.back]=[0,0],this.run={rows:0,peak:0,travel:0,from:this.lanes[0].loop.x[2]}}stand(t){[this.active,this.pulled]=[[],{until:-1,force:0}],this.hand={...this.hand,force:0},this.score=this.score.anew(t),this.build(this.lanes.map(()=>[t,0,0,0,0,0])),this.recorder.begin(this.t,t,this.steer),C.hear({kind:"Acted",t:this.t})}result(){const{rows:t,peak:e,travel:n}=this.run,{fallen:s}=this.lanes[0].loop;return{fell:s,seconds:Ro((t-1)*this.facts.every),peak:Ro(e),travel:Ro(n*this.facts.look.wheel_radius),best:Ro(this.score.run)}}handIn(t){const{facts:e}=this,n={...this.setup,...e.setup,gains:this.setup.controller==="gains"?this.setup.gains:[]},s=e.setup&&this.recorder.handIn(t,n,e.period,this.t,this.result());if(!s)return C.hear({kind:"Notice",level:"error",parts:{},key:e.setup?"noRun":"noReplay",job:""});Hd("hand-in.json",s,"application/json")}keepTraces(){const{t,x:e,volts:n}=C.traces,s=this.facts.look.command_unit,o=$s.map((h,u)=>[`truth/${h}`,Qp[u],e[0][u]]);o.push(["applied/left",s,n[0]],["applied/right",s,n[1]]);const r={robot:{name:this.setup.robot},controller:{kind:this.controller?.kind??Mc},body:{kind:"nonlinear model, in a page",real:!1}},a=JSON.stringify({units:Object.fromEntries(o.map(([h,u])=>[h,u])),origin:r}),l=t.map((h,u)=>[h,...o.map(([,,d])=>d[u])].join()),c=[`# upright-log: ${a}`,["t",...o.map(([h])=>h)].join(),...l].join(`
`)+`
`;Hd("run.csv",c,"text/csv")}strike(t,e){const{look:n,equations:s,every:o}=this.facts,r=this.t;if(this.score.push(),C.hear({kind:"Acted",t:r}),t==="pull_left"||t==="pull_right")this.pulled={until:r+Bd,force:t==="pull_left"?e:-e},this.active.push({force:e,start:r,duration:Bd,height:0});else if(t==="impulse"){const a=Math.max(Math.round(aR/o),1)*o;this.active.push({force:e/a,start:r,duration:a,height:n.com_height})}else{const a=-s.weight*Math.sin(e)/(n.com_height*Math.cos(e)+n.wheel_radius);this.active.push({force:a,start:r,duration:lR,height:n.com_height})}}tick(){const t=performance.now(),e=Math.min((t-this.wall)/1e3,uR);this.wall=t,!this.paused&&(this.advance(e*this.speed),this.spent+=performance.now()-t,this.show())}advance(t){const{every:e}=this.facts;for(this.owed+=t;this.owed>=e*(1-1e-9);)this.owed-=e,this.period()}stepped(t){[this.paused,this.back]=[!0,0];for(let e=0;e<t;e+=1)this.period()}period(){const{every:t,look:e,pull:n}=this.facts,{t:s}=this;this.active=this.active.filter(_=>s<_.start+_.duration-1e-9);const o=this.hand.force?[...this.active,this.hand]:this.active,r=this.acting;JA(o,s,this.setup.slope,r);const a=s<this.pulled.until-1e-9?this.pulled.force:0;this.pulling=a;const l=this.steer.speed/e.wheel_radius;this.target.set([0,0,this.target[2]+l*t,l,this.target[4]+this.steer.rate*t,this.steer.rate]),this.noted();for(const{loop:_}of this.lanes)_.twist=a*n,_.fallen||_.step(this.target,(g,m)=>m.set(r));this.periods+=1;const{x:c,applied:h,fallen:u}=this.lanes[0].loop,d=this.score.watch(t,a?0:r[0],c[0],c[1],h,u);d&&C.hear(d);const p=this.kept.at(-1);(!p||this.t-p.t>=zd-1e-9)&&this.kept.push(this.snapshot()),this.kept.length>hR/zd+200&&this.kept.splice(0,200)}noted(){const{x:t,fallen:e}=this.lanes[0].loop;e||(this.run.rows+=1,this.run.peak=Math.max(this.run.peak,Math.abs(t[0])),this.run.travel=Math.max(this.run.travel,Math.abs(t[2]-this.run.from)))}snapshot(){const t=this.lanes[0],e=this.facts.look.limit??1/0,n=(t.loop.sent[0]**2>=e**2?1:0)+(t.loop.sent[1]**2>=e**2?2:0);return this.n+=1,{kind:"Snapshot",n:this.n,t:this.t,x:this.lanes.map(s=>s.row()),e:this.controller?t.estimate(this.controller):[],f:[...this.acting,this.pulling],r:t.shifted(this.target),s:n,paused:!1,back:0}}show(){const t=this.snapshot();if(this.back){const s=this.kept.findLast(o=>o.t<=t.t-this.back)??this.kept[0]??t;return this.n+=1,C.hear({...s,n:this.n,paused:!0,back:this.back})}const e=C.traces.t.at(-1)??-1/0,n=this.kept.findLastIndex(s=>s.t<=e);for(const s of this.kept.slice(n+1))s.t<t.t&&C.traces.add(s);C.hear({...t,paused:this.paused})}}function Hd(i,t,e){C.hear({kind:"Made",name:i,url:URL.createObjectURL(new Blob([t],{type:e}))})}const pR=1e3,mR=["nonlinear","linear"],gR=["twin","nonlinear","linear","published"];let Vd=0;function Sc(){if(Qe)return pm(Qe);const{robots:i,families:t,kits:e,units:n}=C.catalogue??{robots:[],families:[],kits:[],units:{}},s=t.map(r=>r.name),o=C.role==="alone"?Hi.bodies:mR;return{usual:{...Hi,bodies:o},robots:Object.fromEntries(i.map(({name:r,kit:a})=>[r,{kit:a,controllers:s}])),kits:e,bodies:gR,parameters:Object.keys(n),keys:Object.keys(Hi)}}function Hh(){return location.href.split("#")[0]+WT(C.setup,C.last.push,Sc())}function _R(){if(!Pa(location.hash))return;const{setup:i,push:t,robot:e,controller:n,left:s}=$T(location.hash,Sc()),{robots:o}=Sc();C.change(i);const r=()=>[e&&F("noSuchRobot",{name:e,shown:i.robot,all:Object.keys(o).join(", ")}),n&&F("noSuchController",{name:n,shown:i.controller,all:o[i.robot].controllers.join(", ")}),s.length&&F("leftOut",{parts:s.join(", ")})].filter(Boolean).join(" ");r()&&C.say(r,"error"),C.last.name(t),window.clearTimeout(Vd);const a=()=>{Vd=C.settled?window.setTimeout(()=>(t||C.falls)&&C.send(GT(t??["tilt",Qa])),pR):window.setTimeout(a,100)};a()}const vR=1e3,xR=500;class mm{constructor(t){this.job=t;const e=t.startsWith("keep "),n=un(()=>e?F("writing"):Ye(t));n.id=Ws("job"),this.done.setAttribute("aria-labelledby",n.id);const s=un(()=>e?"":Ye(`doing_${t}`)),o={kind:"Cancel",job:t};this.root=U("div.bar",U("b",n),U("button",{type:"button",onclick:()=>C.send(o),"data-key":`stop-${t}`},un(()=>F("stop"))),this.done,this.words,U("p.note",s));const r=window.setInterval(()=>this.share<1?this.say():window.clearInterval(r),xR);this.say()}root;done=U("progress",{max:1});words=U("span.note");first={share:0,at:0};left=NaN;share=0;began=performance.now();at=this.began;to(t){const e=performance.now();t>0&&!this.first.share&&(this.first={share:t,at:e}),t>this.first.share&&e>this.first.at+vR&&(this.left=(1-t)*(e-this.first.at)/(t-this.first.share)),[this.share,this.at]=[t,e],this.done.value=t,this.say()}say(){const[t,e]=[performance.now(),o=>String(Math.ceil(o/1e3))],n=this.left-(t-this.at),s=Number.isNaN(n)?F("soFar",{seconds:e(t-this.began)}):n>0?F("stillTakes",{seconds:e(n)}):F("overdue",{seconds:e(t-this.began)});this.words.textContent=this.share?`${(100*this.share).toFixed(0)} % · ${s}`:F("oneAtATime")}}const bR=["127.0.0.1","localhost","[::1]"],yR=Kp(120,i=>C.change(i));let Rl={};function wc(i){Rl={...Rl,...i},C.expect(i),yR(Rl)}function ai(i,t,e){return[i,Ca(t,{...e,key:i},n=>wc({[i]:n}))]}class MR{root=U("div.panel-body");noCertificate=U("p.note.column.full");weights=U("div.sliders");numbers=U("div.numbers");gain=U("div");light=U("div.light",{role:"status"});reasons=U("div");sliders=[];shape="";bar=null;working=U("div");reported=null;certified=U("div.column.full.certified",{"aria-live":"polite"});page=new um;build(){this.shape="",this.reported=null,jt(this.certified);const t=(C.catalogue?.families??[]).map(s=>[s.name,Ye(s.name)]),e=us(F("family"),t,C.setup.controller,s=>{C.change({controller:s,gains:s==="gains"?this.present():C.setup.gains}),s==="off"&&C.send({kind:"StandUp",pitch:Qa})},"controller"),n=ne(F("fullCertificate"),()=>C.send({kind:"Start",job:"certify",file:""}),"certify");jt(this.root,U("div.column",e,this.weights),U("div.column.full",this.gain),U("div.column.full",this.numbers),Qe?this.noCertificate:U("div.column.full",this.light,n,this.working,this.reasons),this.certified),this.update()}certify(){this.update(),this.certified.scrollIntoView({block:"nearest"})}certifying(t){const e=this.root.querySelector("[data-key=certify]");if(e?.toggleAttribute("aria-busy",t<1),e&&(e.textContent=F("fullCertificate")+(t<1?`: ${(100*t).toFixed(0)} %`:"")),t>=1&&!this.bar)return;const n=!this.bar;this.bar??=new mm("certify"),this.bar.to(t),jt(this.working,t<1?this.bar.root:null),n&&this.working.scrollIntoView({block:"nearest"}),t>=1&&(this.bar=null)}present(){return C.analysed?.gain[0]?.slice(0,6)??[]}update(){Uh(this.root,"controller",C.setup.controller);const t=`${C.setup.controller} ${C.unit} ${C.byHand&&this.byHand().length}`;t!==this.shape&&this.shapeWeights(t),this.sliders.forEach((e,n)=>e.set(C.byHand?this.byHand()[n]??0:this.sizes()[n])),Ml(this.gain,!C.off&&!C.analysed,...this.gains()),Ml(this.numbers,!C.off&&!C.analysed,...fm()),jt(this.light,...SR()),Ml(this.reasons,!C.off&&!C.lit?.heads.en,wR()),this.noCertificate.textContent=F(C.byHand||C.off?"noCertificateByHand":"noCertificateHere"),this.reported!==C.certified&&(this.reported=C.certified,jt(this.certified,...this.reported?[U("p",F("certified")),this.page.show(this.reported)]:[]))}byHand(){return C.setup.gains.length?C.setup.gains:this.present()}usual(){return[...C.catalogue?.largest??[],C.catalogue?.command[C.unit]??1]}sizes(){return C.setup.largest.length?C.setup.largest:this.usual()}shapeWeights(t){this.shape=t;const e=C.catalogue?.families.find(n=>n.name===C.setup.controller);if(this.sliders=[],C.byHand){const n=this.byHand(),s=Math.max(...n.map(Math.abs),.1),o=a=>`${C.unit}${a%2?" s":""}/rad`,r=a=>Math.max(4*Math.abs(n[a]??0),s/4);this.sliders=Hs.map((a,l)=>Ca(`${a} ${Ye($s[l])} → u`,{low:-r(l),high:r(l),step:r(l)/500,show:c=>`${fe(c,4)} ${o(l)}`,typed:o(l),key:`gain-${l}`},c=>{const h=[...this.byHand().length?this.byHand():[0,0,0,0,0,0]];h[l]=c,wc({gains:h})})),jt(this.weights,...this.sliders.map(a=>a.root))}else if(e?.weights&&!Qe){this.sliders=this.usual().map((s,o)=>this.weight(s,o));const n=ne(F("ownWeights"),()=>C.change({largest:[]}),"own-weights",{className:"quiet"});jt(this.weights,U("p.note",F("weights")),...this.sliders.map(s=>s.root),n)}else jt(this.weights,!C.off&&U("p.note",F(e?.weights?"fixedWeights":"noWeights")))}weight(t,e){const n=e<6?tm[e]:` ${C.unit}`,s=e<6?Ja:1,o=e<6?`${Hs[e]} ${Ye($s[e])}`:F("command");return Ca(o,{low:t/10,high:t*10,log:!0,show:r=>`${fe(s*r,2)}${n}`,key:`weight-${e}`},r=>{const a=[...this.sizes()];a[e]=r,wc({largest:a})})}gains(){const t=C.analysed?.gain??[];return!t.length||C.byHand||C.off?[]:[U("h4",F("gain")),Yp(Hs,[t[0].map(e=>fe(e,3))],"gains"),U("p.note",F("gainNote",{unit:C.unit}))]}}function gm(){const i=C.lit?.light??"none";return C.off||i==="none"&&C.analysed!==null&&sR(C.analysed)?"red":i}function Ec(i=!1){const{setup:t,lit:e,trying:n,jobs:s}=C;if(C.off)return F("unlitOff");if(!e?.heads.en)return n?i?`${(100*n.fraction).toFixed(0)} % …`:F("tried",{n:Math.round(n.fraction*n.runs),all:n.runs}):F(s.size?"queued":"none");if(e.light==="none")return F("noCertificate");const o=i?F(e.light):Gi(e.heads).verdict;return t.payload>0?F(t.slope&&!i?"litBoth":"litPayload",{light:o}):t.slope?F("litSlope",{light:o}):o}function SR(){const i=U("span",{className:`lamp ${gm()}`,"aria-hidden":"true"});return[U("h4",F("certificate")),U("p.lit",i,U("b",Ec()))]}function wR(){return C.off||C.certified?null:C.lit?.heads.en?hm({...Gi(C.lit.heads),verdict:""}):C.jobs.size?null:U("p.note",F("lightNote"))}class ER{root=U("div.panel-body");sliders=[];table=U("div.parameters");fields=new Map;shown="";opened=!1;title=U("p.note");build(){this.shown="",this.fields.clear();const t=(C.catalogue?.robots??[]).map(s=>[s.name,s.name]);t.some(([s])=>s===C.setup.robot)||t.push([C.setup.robot,C.setup.robot]);const e=us(F("preset"),t,C.setup.robot,s=>this.choose(s),"robot");this.sliders=[ai("payload",F("payload"),{low:0,high:this.weight(),step:.005,show:s=>`${fe(s*1e3,3)} g`}),ai("payload_height",F("payloadHeight"),{low:0,high:.5,step:.005,show:s=>`${fe(s*100,3)} cm`}),ai("slope",F("slope"),{low:-.2,high:.2,step:.005,show:kh}),ai("grip",F("grip"),{low:.02,high:10,log:!0,show:s=>fe(s,2)})];const n=U("details",{open:this.opened,ontoggle:()=>this.opened=n.open},U("summary",F("numbers")),U("p.note",F("numbersNote")),this.table);jt(this.root,U("div.column",e,this.title,_m(F("openRobot"),".toml","robot")),U("div.column",U("div.sliders",...this.sliders.map(([,s])=>s.root))),U("div.column",this.bodies()),U("div.column.full",n)),this.update()}weight(){return Math.max(.3,(C.changed?.look.weight??6)/9.81*.6)}choose(t){const e=C.catalogue?.robots.find(n=>n.name===t);e&&C.change({robot:t,numbers:{},drive:"",kit:e.kit,largest:[],gains:[],payload:0,delay:-1,voltage:-1,dead_zone:-1})}bodies(){const t=["twin","nonlinear","linear","published",...C.changed?.bodies.includes("calibrated")?["calibrated"]:[]],e=t.map(n=>{const s=Ws("body"),o=U("input",{type:"checkbox",id:s,checked:C.setup.bodies.includes(n),"data-key":`body-${n}`,onchange:()=>{const r=t.filter(a=>a===n?o.checked:C.setup.bodies.includes(a));r.length?C.change({bodies:r}):o.checked=!0}});return U("label",{for:s,className:"check"},o,sm(n))});return U("fieldset",U("legend",F("bodies")),...e)}update(){for(const[s,o]of this.sliders)o.set(C.setup[s]);const t=C.catalogue?.robots.find(s=>s.name===C.setup.robot);this.title.textContent=t?Gi(t.title):"";const e=JSON.stringify([C.setup.robot,C.setup.numbers,C.changed?.bodies]);if(e===this.shown)return;const n=this.shown!=="";this.shown=e,n&&!this.root.contains(document.activeElement)&&this.build(),this.parameters()}parameters(){const e={...C.catalogue?.robots.find(s=>s.name===C.setup.robot)?.numbers??{},...C.setup.numbers};if(Object.keys(e).join()===[...this.fields.keys()].join())return this.fields.forEach((s,o)=>s.set(e[o]));this.fields.clear();const n=Object.keys(e).map(s=>{const o=Ws("number"),r=Xp(l=>C.change({numbers:{...C.setup.numbers,[s]:l}}),{id:o,"data-key":`number-${s}`});this.fields.set(s,r);const a=C.catalogue?.symbols[s]??"";return U("div.parameter",U("label",{for:o},`${Gi(C.catalogue?.names??{})?.[s]??s} ${a}`),r.root,U("span",(C.catalogue?.units[s]??"").replace(/^1$/,"")))});this.fields.forEach((s,o)=>s.set(e[o])),jt(this.table,...n,ne(F("ownNumbers"),()=>C.change({numbers:{},drive:""}),"own-numbers",{className:"quiet"}))}}class TR{root=U("div.panel-body");sliders=[];anew=U("p.note");build(){const t=(C.catalogue?.kits??[]).map(o=>[o,o==="ideal"?F("ideal"):o]),e=us(F("kit"),t,C.setup.kit,o=>C.change({kit:o,delay:-1,voltage:-1,dead_zone:-1,noise:1}),"kit"),{unit:n}=C;this.sliders=[ai("noise",F("noise"),{low:0,high:10,step:.1,show:o=>`× ${fe(o,2)}`}),ai("delay",F("delay"),{low:0,high:.04,step:.002,show:o=>`${fe(o*1e3,2)} ms`}),ai("voltage",F("voltage"),{low:1,high:14,step:.1,show:o=>o>0?`${fe(o,3)} V`:F("unlimited")}),ai("dead_zone",F("deadZone"),{low:0,high:n==="V"?2:.1,show:o=>`${fe(o,2)} ${n}`})];const s=ne(F("ownKit"),()=>C.change({noise:1,delay:-1,voltage:-1,dead_zone:-1}),"own-kit",{className:"quiet"});jt(this.root,U("div.column",e,s),U("div.column.wide",U("div.sliders",...this.sliders.map(([,o])=>o.root)),this.anew)),this.update()}update(){const t=C.changed?.kit??{};for(const[e,n]of this.sliders)n.set(e==="noise"?C.setup.noise:t[e]);this.anew.textContent=C.byHand||C.off?"":F("redesigned"),Uh(this.root,"kit",C.setup.kit)}}function Ua(i,t=""){C.send({kind:"Save",what:i,name:t,language:Oo()})}function Ms(i,t){return ne(t,()=>Ua(i),`keep-${i}`)}function _m(i,t,e){const n=Ws("file"),s=U("input",{type:"file",id:n,accept:t,className:"file","data-key":`open-${e}`,onchange:()=>{const o=s.files?.[0];s.value="",o&&AR(o,e)}});return U("div.upload",s,U("label",{for:n,className:"button"},i))}let Ns="",vm=()=>{};async function AR(i,t){const e=`upload/${C.session}?what=${t}&name=${encodeURIComponent(i.name)}`;C.say(()=>F("uploaded",{name:i.name}));try{const n=await fetch(e,{method:"POST",body:i}),{name:s,error:o}=await n.json();o?C.say(()=>Mr(o),"error"):t==="log"&&(Ns=s??"",vm())}catch{C.say(()=>F("lost"),"error")}}const Tc="compare.html";class RR{root=U("div.panel-body");bars=U("div.bars");result=U("div.result",{role:"region","aria-live":"polite"});running=new Map;source="";comparison=U("p.comparison",{role:"status"});robot="";failed=U("p.failed",{role:"alert"});load=0;page=new um(t=>this.next(t));constructor(){vm=()=>zs(()=>this.build())}build(){const t=[["",F("thisRun")]];Ns&&t.push([Ns,Ns.replace(/^in-/,"")]),Ns&&(this.source=Ns);const e=us(F("source"),t,this.source,o=>this.source=o,"source"),n=U("div.row",ne(F("doctor"),()=>this.start("doctor"),"doctor",{title:F("doctorTip")}),ne(F("calibrate"),()=>this.start("calibrate"),"calibrate",{title:F("calibrateTip")}),ne(F("compare"),()=>this.compare(),"compare",{title:F("compareTip")})),s=".csv,.txt,.log,.tsv,.dat,.json,.mat,.parquet,.mcap";this.changed();for(const o of[this.comparison,this.failed])Nh(o);jt(this.root,U("div.column",e,_m(F("openLog"),s,"log"),n,this.failed,this.comparison,U("p.note",F("calibrateNote")),this.bars),U("div.column.wide",this.result)),this.found()}start(t){jt(this.failed),this.load=this.source?0:C.setup.payload,C.send({kind:"Start",job:t,file:this.source})}fail(t,e){this.robot=C.setup.robot,jt(this.failed,un(t),e==="doctor"&&ne(F("doctor"),()=>this.start("doctor"),"next-doctor")),this.failed.scrollIntoView({block:"nearest"})}changed(){if(this.robot!==C.setup.robot)for(const t of[this.comparison,this.failed])jt(t)}compare(){this.robot=C.setup.robot,jt(this.failed),Ua("compare",this.source);const t=C.jobs.size?"compareWaits":"comparing";jt(this.comparison,un(()=>F(t)))}compared(t){this.robot=C.setup.robot;const e=U("a",{href:t,target:"_blank",rel:"noopener","data-key":"open-comparison"},un(()=>F("open"))),n=U("a",{href:t,download:Tc,"data-key":"save-comparison"},un(()=>F("saveAs",{name:Tc})));jt(this.comparison,un(()=>F("compared"))," ",e," · ",n)}progress(t,e){if(t==="keep compare"){e>=1&&!this.comparison.querySelector("a")&&jt(this.comparison);return}if(t==="design")return;const n=this.running.get(t)??new mm(t);n.to(e),e>=1?(n.root.remove(),this.running.delete(t)):this.running.has(t)||(this.bars.append(n.root),this.running.set(t,n))}next(t){const e=[F("calibrate"),()=>this.start("calibrate")];return{calibrate:t==="calibrate"?[F("robotFile"),()=>Ua("robot")]:e,...t==="doctor"?{}:{doctor:[F("doctor"),()=>this.start("doctor")]}}}found(){const t=C.found;if(!t)return;const e=t.job==="calibrate"&&this.load>0;jt(this.result,e&&U("p.verdict.bad",U("b",F("calibratedLaden",{mass:fe(this.load*1e3,3)}))),this.page.show(t))}}class CR{constructor(t){this.picture=t}root=U("div.panel-body");files=new Map;saved=U("p.saved");linked=U("div");links=U("div.links",{role:"status"},this.linked,this.saved);build(){Nh(this.links);const t=Qe?this.withoutPython():this.withPython();jt(this.root,U("div.column.wide",...t,U("p.note",F("handInNote")),this.handIn(),this.links))}withoutPython(){return[U("p.note",F("csvNote")),U("div.row",Ms("csv",F("csv")),this.pictureButton()),U("p.note",F("keepLive"))]}withPython(){const t=(e,...n)=>U("div",U("h4",e),U("div.row",...n));return[U("p.note",F("keepNote")),t(F("keepData"),Ms("csv",F("csv")),Ms("parquet",F("parquet"))),t(F("keepPages"),Ms("report",F("report")),Ms("replay",F("replay"))),t(F("keepFiles"),Ms("controller",F("controllerFile")),Ms("robot",F("robotFile"))),t(F("keepShow"),this.pictureButton(),ne(F("link"),()=>void this.copy(),"link"))]}handIn(){const t=Ws("student"),e=U("input",{type:"text",id:t,maxLength:40,autocomplete:"name",value:Ui.getItem("name")??"","data-key":"student"}),n=()=>{e.value.trim()?Ua("handin",e.value.trim()):(e.focus(),C.say(()=>F("nameMissing")))};return U("div.row.hand-in",U("label",{for:t},F("yourName")),e,ne(F("handIn"),n,"keep-handin"))}pictureButton(){return ne(F("picture"),()=>void this.photograph(),"picture")}async photograph(){const t=await this.picture();t&&this.made(t.type.includes("svg")?"upright.svg":"upright.png",URL.createObjectURL(t))}async copy(){const[t,{kept:e}]=[Hh(),C.last];history.replaceState(null,"",t),await navigator.clipboard?.writeText(t).catch(()=>{});const n=()=>`${F(bR.includes(location.hostname)?"linkHere":"linkCopied")} ${F(e)}`;C.say(n);const s=U("input",{readOnly:!0,value:t,"aria-label":F("link"),className:"address"});jt(this.linked,U("p.note",un(n)),s),s.select()}made(t,e){const n=U("a",{href:e,download:t},t);this.files.set(t,n),jt(this.saved,un(()=>F("saved")),...[...this.files.values()].flatMap(s=>[" ",s])),n.click()}}const PR=8;class LR{constructor(t){this.session=t}root=U("div.panel-body");sliders=[];title=U("p.note");ghost=null;load=null;build(){const t=(C.catalogue?.robots??[]).map(r=>[r.name,r.name]),e=us(F("preset"),t,C.setup.robot,r=>C.change({robot:r,gains:[],delay:-1}),"robot");this.sliders=[ai("slope",F("slope"),{low:-.2,high:.2,step:.005,show:kh}),ai("noise",F("noise"),{low:0,high:10,step:.1,show:r=>`× ${fe(r,2)}`}),ai("delay",F("delay"),{low:0,high:.05,step:.001,show:r=>`${fe(r*1e3,2)} ms`})];const n=U("input",{type:"checkbox",id:"ghost","data-key":"ghost",onchange:()=>C.change({bodies:n.checked?["nonlinear","linear"]:["nonlinear"]})});this.ghost=n;const s=U("input",{type:"checkbox",id:"load","data-key":"load",onchange:()=>C.change({payload:s.checked?1:0})});this.load=s;const o=ne(F("ownKit"),()=>C.change({slope:0,noise:1,delay:-1,payload:0}),"own-kit",{className:"quiet"});jt(this.root,U("div.column",e,this.title,U("label",{for:"ghost",className:"check"},n,F("ghost")),this.carried),U("div.column.wide",U("div.sliders",...this.sliders.map(([,r])=>r.root),U("p.note",F("stays")),o))),this.update()}carried=U("label",{for:"load",className:"check"});update(){Uh(this.root,"robot",C.setup.robot),this.ghost&&(this.ghost.checked=C.setup.bodies.length>1);const t=this.session()?.facts,e=t?.laden?.look;jt(this.carried,...e&&this.load?[this.load,F("carries",{mass:fe(e.payload*1e3,3),height:fe(e.payload_height*100,3)})]:[]),this.load&&(this.load.checked=C.setup.payload>0),this.title.textContent=t?`${Gi(t.title)} (${F("kit")}: ${t.kit_name})`:"";const n=this.sliders.find(([s])=>s==="delay")?.[1].root.querySelector("input");n&&(n.max=String(Math.max(.05,2*(t?.delay_own??0))));for(const[s,o]of this.sliders)o.set(s==="delay"?C.changed?.kit.delay??0:C.setup[s])}}function Gd(i){const t=i.split(" ").flatMap((s,o)=>[o?" ":"",U("span.token",s)]),e=U("code",{tabIndex:0},...t),n=ne(F("copy"),()=>{getSelection()?.selectAllChildren(e),navigator.clipboard?.writeText(i).then(()=>n.textContent=F("copied"),()=>{})},`copy-${i.replace(/\W+/g,"-")}`,{"aria-label":`${F("copy")}: ${i}`});return U("div.shell",e,n)}class DR{root=U("div.panel-body");shown="";build(){const{robot:t,controller:e}=C.setup;this.shown=JSON.stringify([t,e]);const n=String(parseFloat((PR*(C.changed?.look.wheel_radius??.04)).toPrecision(2))),s={robot:t,controller:e,speed:n},o=["off","gains"].includes(e),r=t==="nxtway-gs"?"--drive":"upright example",l=Za().python.filter(([,c])=>!c.includes(r)).map(([c,h])=>[c,o?h.replace(" -c {controller}",""):h]).filter(([,c])=>!(o&&c.includes("{controller}"))).flatMap(([c,h])=>[U("dt",c),U("dd",Gd(h.replace(/\{(\w+)\}/g,(u,d)=>s[d]??"")))]);jt(this.root,U("div.column.full",U("p.note",F("pythonNote")),Gd(F("install")),U("dl.commands",...l)))}update(){this.shown!==JSON.stringify([C.setup.robot,C.setup.controller])&&this.build()}}function IR(i){return ne(F("lookAtThis"),()=>{const[t,{kept:e}]=[Hh(),C.last],n=()=>window.prompt(F("lookAtThis"),t),s=()=>`${F(location.protocol==="file:"?"lookHere":"lookCopied")} ${F(e)}`;navigator.clipboard?navigator.clipboard.writeText(t).then(()=>i(s),n):n()},"look",{title:F("lookTip")})}class NR{constructor(t,e){this.credentials=t,this.say=e,C.send=n=>this.send(n),this.open()}socket=null;wait=250;closed=!1;first=!0;send(t){C.note(t,C.snapshot?.t??0),this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(t))}open(){this.say(this.first?"connecting":"lost");const t=new URL("ws",document.baseURI);t.protocol=t.protocol.replace("http","ws"),t.hash="";const e=new WebSocket(t);this.socket=e,e.onopen=()=>this.greet(),e.onmessage=n=>this.hear(JSON.parse(n.data)),e.onclose=()=>this.lost()}greet(){const t=this.first&&Pa(location.hash);this.send({kind:"Hello",version:jT,session:t?"":Ui.getItem("session")??"",token:this.credentials.token,name:this.credentials.name,setup:C.changed?C.setup:null})}hear(t){t.kind==="Snapshot"&&this.send({kind:"Ack",n:t.n}),t.kind==="Welcome"&&(Ui.setItem("session",t.session),this.wait=250,this.first=!1,this.say("connected")),t.kind==="Refused"&&(this.closed=!0,this.say("refused",()=>Mr(t.parts))),C.hear(t)}lost(){this.closed||(this.say("lost"),window.setTimeout(()=>this.open(),this.wait),this.wait=Math.min(this.wait*1.6,3e3))}}class Wd{moments;at=0;paused=!1;speed=1;clock=performance.now();constructor(t){const e=t.filter(n=>n.kind==="Snapshot");this.moments=e.map(n=>({...n,t:n.t-e[0].t})),C.recorded=Math.max(this.length(),.02),C.send=n=>this.act(n);for(const n of t)n.kind!=="Snapshot"&&C.hear(n);window.setInterval(()=>this.tick(),20)}static inPage(){const t=document.getElementById("recording");return t?JSON.parse(t.textContent??"[]"):null}tick(){const t=performance.now();!this.paused&&this.moments.length&&(this.at+=(t-this.clock)/1e3*this.speed,this.at>this.length()&&this.rewind(),this.show()),this.clock=t}length(){return this.moments.at(-1)?.t??0}rewind(){this.at=0,C.traces.reset(this.moments[0].x.length)}show(){const t=this.at,e=C.traces.t.at(-1)??-1/0;t<e&&C.traces.until(t);const n=this.moments.filter(o=>o.t>e&&o.t<=t),s=n.at(-1)??this.moments.findLast(o=>o.t<=t);for(const o of n.slice(0,-1))C.traces.add(o);s&&C.hear({...s,paused:this.paused,back:0})}act(t){if(t.kind==="Play")this.paused=t.paused,this.speed=t.speed;else if(t.kind==="Scrub")this.at=Math.max(0,this.length()-t.back);else if(t.kind==="Step")this.paused=!0,this.at=Math.min(this.at+.02*t.periods,this.length());else if(t.kind==="StandUp")this.rewind();else return;this.show()}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Vh="170",UR=0,$d=1,kR=2,xm=1,bm=2,Ni=3,fs=0,Ln=1,ki=2,as=0,Lo=1,qd=2,Xd=3,jd=4,FR=5,Us=100,OR=101,BR=102,zR=103,HR=104,VR=200,GR=201,WR=202,$R=203,Ac=204,Rc=205,qR=206,XR=207,jR=208,YR=209,KR=210,ZR=211,JR=212,QR=213,tC=214,Cc=0,Pc=1,Lc=2,Bo=3,Dc=4,Ic=5,Nc=6,Uc=7,ym=0,eC=1,nC=2,ls=0,iC=1,sC=2,oC=3,rC=4,aC=5,lC=6,cC=7,Mm=300,zo=301,Ho=302,kc=303,Fc=304,tl=306,ka=1e3,Fs=1001,Oc=1002,ci=1003,hC=1004,qr=1005,xi=1006,Cl=1007,Os=1008,Wi=1009,Sm=1010,wm=1011,wr=1012,Gh=1013,qs=1014,Fi=1015,Er=1016,Wh=1017,$h=1018,Vo=1020,Em=35902,Tm=1021,Am=1022,li=1023,Rm=1024,Cm=1025,Do=1026,Go=1027,Pm=1028,qh=1029,Lm=1030,Xh=1031,jh=1033,ba=33776,ya=33777,Ma=33778,Sa=33779,Bc=35840,zc=35841,Hc=35842,Vc=35843,Gc=36196,Wc=37492,$c=37496,qc=37808,Xc=37809,jc=37810,Yc=37811,Kc=37812,Zc=37813,Jc=37814,Qc=37815,th=37816,eh=37817,nh=37818,ih=37819,sh=37820,oh=37821,wa=36492,rh=36494,ah=36495,Dm=36283,lh=36284,ch=36285,hh=36286,uC=3200,dC=3201,Im=0,fC=1,os="",Bn="srgb",Ko="srgb-linear",el="linear",Ce="srgb",ho=7680,Yd=519,pC=512,mC=513,gC=514,Nm=515,_C=516,vC=517,xC=518,bC=519,Kd=35044,Zd="300 es",Oi=2e3,Fa=2001;class Zo{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const n=this._listeners;return n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const o=s.indexOf(e);o!==-1&&s.splice(o,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const n=this._listeners[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let o=0,r=s.length;o<r;o++)s[o].call(this,t);t.target=null}}}const _n=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Pl=Math.PI/180,uh=180/Math.PI;function Tr(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(_n[i&255]+_n[i>>8&255]+_n[i>>16&255]+_n[i>>24&255]+"-"+_n[t&255]+_n[t>>8&255]+"-"+_n[t>>16&15|64]+_n[t>>24&255]+"-"+_n[e&63|128]+_n[e>>8&255]+"-"+_n[e>>16&255]+_n[e>>24&255]+_n[n&255]+_n[n>>8&255]+_n[n>>16&255]+_n[n>>24&255]).toLowerCase()}function Pn(i,t,e){return Math.max(t,Math.min(e,i))}function yC(i,t){return(i%t+t)%t}function Ll(i,t,e){return(1-e)*i+e*t}function ar(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Cn(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}class xe{constructor(t=0,e=0){xe.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Pn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),o=this.x-t.x,r=this.y-t.y;return this.x=o*n-r*s+t.x,this.y=o*s+r*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class ee{constructor(t,e,n,s,o,r,a,l,c){ee.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,o,r,a,l,c)}set(t,e,n,s,o,r,a,l,c){const h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=o,h[5]=l,h[6]=n,h[7]=r,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,o=this.elements,r=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],p=n[5],_=n[8],g=s[0],m=s[3],f=s[6],M=s[1],S=s[4],x=s[7],k=s[2],P=s[5],A=s[8];return o[0]=r*g+a*M+l*k,o[3]=r*m+a*S+l*P,o[6]=r*f+a*x+l*A,o[1]=c*g+h*M+u*k,o[4]=c*m+h*S+u*P,o[7]=c*f+h*x+u*A,o[2]=d*g+p*M+_*k,o[5]=d*m+p*S+_*P,o[8]=d*f+p*x+_*A,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],o=t[3],r=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*r*h-e*a*c-n*o*h+n*a*l+s*o*c-s*r*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],o=t[3],r=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*r-a*c,d=a*l-h*o,p=c*o-r*l,_=e*u+n*d+s*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const g=1/_;return t[0]=u*g,t[1]=(s*c-h*n)*g,t[2]=(a*n-s*r)*g,t[3]=d*g,t[4]=(h*e-s*l)*g,t[5]=(s*o-a*e)*g,t[6]=p*g,t[7]=(n*l-c*e)*g,t[8]=(r*e-n*o)*g,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,o,r,a){const l=Math.cos(o),c=Math.sin(o);return this.set(n*l,n*c,-n*(l*r+c*a)+r+t,-s*c,s*l,-s*(-c*r+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(Dl.makeScale(t,e)),this}rotate(t){return this.premultiply(Dl.makeRotation(-t)),this}translate(t,e){return this.premultiply(Dl.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const Dl=new ee;function Um(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Oa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function MC(){const i=Oa("canvas");return i.style.display="block",i}const Jd={};function _r(i){i in Jd||(Jd[i]=!0,console.warn(i))}function SC(i,t,e){return new Promise(function(n,s){function o(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(o,e);break;default:n()}}setTimeout(o,e)})}function wC(i){const t=i.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function EC(i){const t=i.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const ve={enabled:!0,workingColorSpace:Ko,spaces:{},convert:function(i,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Ce&&(i.r=Vi(i.r),i.g=Vi(i.g),i.b=Vi(i.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(i.applyMatrix3(this.spaces[t].toXYZ),i.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Ce&&(i.r=Io(i.r),i.g=Io(i.g),i.b=Io(i.b))),i},fromWorkingColorSpace:function(i,t){return this.convert(i,this.workingColorSpace,t)},toWorkingColorSpace:function(i,t){return this.convert(i,t,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===os?el:this.spaces[i].transfer},getLuminanceCoefficients:function(i,t=this.workingColorSpace){return i.fromArray(this.spaces[t].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,t,e){return i.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function Vi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Io(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}const Qd=[.64,.33,.3,.6,.15,.06],tf=[.2126,.7152,.0722],ef=[.3127,.329],nf=new ee().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sf=new ee().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);ve.define({[Ko]:{primaries:Qd,whitePoint:ef,transfer:el,toXYZ:nf,fromXYZ:sf,luminanceCoefficients:tf,workingColorSpaceConfig:{unpackColorSpace:Bn},outputColorSpaceConfig:{drawingBufferColorSpace:Bn}},[Bn]:{primaries:Qd,whitePoint:ef,transfer:Ce,toXYZ:nf,fromXYZ:sf,luminanceCoefficients:tf,outputColorSpaceConfig:{drawingBufferColorSpace:Bn}}});let uo;class TC{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{uo===void 0&&(uo=Oa("canvas")),uo.width=t.width,uo.height=t.height;const n=uo.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),e=uo}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=Oa("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),o=s.data;for(let r=0;r<o.length;r++)o[r]=Vi(o[r]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Vi(e[n]/255)*255):e[n]=Vi(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let AC=0;class km{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:AC++}),this.uuid=Tr(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let o;if(Array.isArray(s)){o=[];for(let r=0,a=s.length;r<a;r++)s[r].isDataTexture?o.push(Il(s[r].image)):o.push(Il(s[r]))}else o=Il(s);n.url=o}return e||(t.images[this.uuid]=n),n}}function Il(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?TC.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let RC=0;class Tn extends Zo{constructor(t=Tn.DEFAULT_IMAGE,e=Tn.DEFAULT_MAPPING,n=Fs,s=Fs,o=xi,r=Os,a=li,l=Wi,c=Tn.DEFAULT_ANISOTROPY,h=os){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:RC++}),this.uuid=Tr(),this.name="",this.source=new km(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=o,this.minFilter=r,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new xe(0,0),this.repeat=new xe(1,1),this.center=new xe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ee,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Mm)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ka:t.x=t.x-Math.floor(t.x);break;case Fs:t.x=t.x<0?0:1;break;case Oc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ka:t.y=t.y-Math.floor(t.y);break;case Fs:t.y=t.y<0?0:1;break;case Oc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}Tn.DEFAULT_IMAGE=null;Tn.DEFAULT_MAPPING=Mm;Tn.DEFAULT_ANISOTROPY=1;class $e{constructor(t=0,e=0,n=0,s=1){$e.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,o=this.w,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s+r[12]*o,this.y=r[1]*e+r[5]*n+r[9]*s+r[13]*o,this.z=r[2]*e+r[6]*n+r[10]*s+r[14]*o,this.w=r[3]*e+r[7]*n+r[11]*s+r[15]*o,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,o;const l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],p=l[5],_=l[9],g=l[2],m=l[6],f=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-g)<.01&&Math.abs(_-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+g)<.1&&Math.abs(_+m)<.1&&Math.abs(c+p+f-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const S=(c+1)/2,x=(p+1)/2,k=(f+1)/2,P=(h+d)/4,A=(u+g)/4,I=(_+m)/4;return S>x&&S>k?S<.01?(n=0,s=.707106781,o=.707106781):(n=Math.sqrt(S),s=P/n,o=A/n):x>k?x<.01?(n=.707106781,s=0,o=.707106781):(s=Math.sqrt(x),n=P/s,o=I/s):k<.01?(n=.707106781,s=.707106781,o=0):(o=Math.sqrt(k),n=A/o,s=I/o),this.set(n,s,o,e),this}let M=Math.sqrt((m-_)*(m-_)+(u-g)*(u-g)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(m-_)/M,this.y=(u-g)/M,this.z=(d-h)/M,this.w=Math.acos((c+p+f-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class CC extends Zo{constructor(t=1,e=1,n={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new $e(0,0,t,e),this.scissorTest=!1,this.viewport=new $e(0,0,t,e);const s={width:t,height:e,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:xi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);const o=new Tn(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);o.flipY=!1,o.generateMipmaps=n.generateMipmaps,o.internalFormat=n.internalFormat,this.textures=[];const r=n.count;for(let a=0;a<r;a++)this.textures[a]=o.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,o=this.textures.length;s<o;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let n=0,s=t.textures.length;n<s;n++)this.textures[n]=t.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new km(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Xs extends CC{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class Fm extends Tn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class PC extends Tn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Ar{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,o,r,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3];const d=o[r+0],p=o[r+1],_=o[r+2],g=o[r+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u;return}if(a===1){t[e+0]=d,t[e+1]=p,t[e+2]=_,t[e+3]=g;return}if(u!==g||l!==d||c!==p||h!==_){let m=1-a;const f=l*d+c*p+h*_+u*g,M=f>=0?1:-1,S=1-f*f;if(S>Number.EPSILON){const k=Math.sqrt(S),P=Math.atan2(k,f*M);m=Math.sin(m*P)/k,a=Math.sin(a*P)/k}const x=a*M;if(l=l*m+d*x,c=c*m+p*x,h=h*m+_*x,u=u*m+g*x,m===1-a){const k=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=k,c*=k,h*=k,u*=k}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,o,r){const a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=o[r],d=o[r+1],p=o[r+2],_=o[r+3];return t[e]=a*_+h*u+l*p-c*d,t[e+1]=l*_+h*d+c*u-a*p,t[e+2]=c*_+h*p+a*d-l*u,t[e+3]=h*_-a*u-l*d-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,o=t._z,r=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(o/2),d=l(n/2),p=l(s/2),_=l(o/2);switch(r){case"XYZ":this._x=d*h*u+c*p*_,this._y=c*p*u-d*h*_,this._z=c*h*_+d*p*u,this._w=c*h*u-d*p*_;break;case"YXZ":this._x=d*h*u+c*p*_,this._y=c*p*u-d*h*_,this._z=c*h*_-d*p*u,this._w=c*h*u+d*p*_;break;case"ZXY":this._x=d*h*u-c*p*_,this._y=c*p*u+d*h*_,this._z=c*h*_+d*p*u,this._w=c*h*u-d*p*_;break;case"ZYX":this._x=d*h*u-c*p*_,this._y=c*p*u+d*h*_,this._z=c*h*_-d*p*u,this._w=c*h*u+d*p*_;break;case"YZX":this._x=d*h*u+c*p*_,this._y=c*p*u+d*h*_,this._z=c*h*_-d*p*u,this._w=c*h*u-d*p*_;break;case"XZY":this._x=d*h*u-c*p*_,this._y=c*p*u-d*h*_,this._z=c*h*_+d*p*u,this._w=c*h*u+d*p*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+r)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],o=e[8],r=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){const p=.5/Math.sqrt(d+1);this._w=.25/p,this._x=(h-l)*p,this._y=(o-c)*p,this._z=(r-s)*p}else if(n>a&&n>u){const p=2*Math.sqrt(1+n-a-u);this._w=(h-l)/p,this._x=.25*p,this._y=(s+r)/p,this._z=(o+c)/p}else if(a>u){const p=2*Math.sqrt(1+a-n-u);this._w=(o-c)/p,this._x=(s+r)/p,this._y=.25*p,this._z=(l+h)/p}else{const p=2*Math.sqrt(1+u-n-a);this._w=(r-s)/p,this._x=(o+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<Number.EPSILON?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Pn(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,o=t._z,r=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+r*a+s*c-o*l,this._y=s*h+r*l+o*a-n*c,this._z=o*h+r*c+n*l-s*a,this._w=r*h-n*a-s*l-o*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const n=this._x,s=this._y,o=this._z,r=this._w;let a=r*t._w+n*t._x+s*t._y+o*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=r,this._x=n,this._y=s,this._z=o,this;const l=1-a*a;if(l<=Number.EPSILON){const p=1-e;return this._w=p*r+e*this._w,this._x=p*n+e*this._x,this._y=p*s+e*this._y,this._z=p*o+e*this._z,this.normalize(),this}const c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-e)*h)/c,d=Math.sin(e*h)/c;return this._w=r*u+this._w*d,this._x=n*u+this._x*d,this._y=s*u+this._y*d,this._z=o*u+this._z*d,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),o=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),o*Math.sin(e),o*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class et{constructor(t=0,e=0,n=0){et.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(of.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(of.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,o=t.elements;return this.x=o[0]*e+o[3]*n+o[6]*s,this.y=o[1]*e+o[4]*n+o[7]*s,this.z=o[2]*e+o[5]*n+o[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,o=t.elements,r=1/(o[3]*e+o[7]*n+o[11]*s+o[15]);return this.x=(o[0]*e+o[4]*n+o[8]*s+o[12])*r,this.y=(o[1]*e+o[5]*n+o[9]*s+o[13])*r,this.z=(o[2]*e+o[6]*n+o[10]*s+o[14])*r,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,o=t.x,r=t.y,a=t.z,l=t.w,c=2*(r*s-a*n),h=2*(a*e-o*s),u=2*(o*n-r*e);return this.x=e+l*c+r*u-a*h,this.y=n+l*h+a*c-o*u,this.z=s+l*u+o*h-r*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s,this.y=o[1]*e+o[5]*n+o[9]*s,this.z=o[2]*e+o[6]*n+o[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,o=t.z,r=e.x,a=e.y,l=e.z;return this.x=s*l-o*a,this.y=o*r-n*l,this.z=n*a-s*r,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Nl.copy(this).projectOnVector(t),this.sub(Nl)}reflect(t){return this.sub(Nl.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Pn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Nl=new et,of=new Ar;class Rr{constructor(t=new et(1/0,1/0,1/0),e=new et(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Jn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Jn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=Jn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const o=n.getAttribute("position");if(e===!0&&o!==void 0&&t.isInstancedMesh!==!0)for(let r=0,a=o.count;r<a;r++)t.isMesh===!0?t.getVertexPosition(r,Jn):Jn.fromBufferAttribute(o,r),Jn.applyMatrix4(t.matrixWorld),this.expandByPoint(Jn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Xr.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Xr.copy(n.boundingBox)),Xr.applyMatrix4(t.matrixWorld),this.union(Xr)}const s=t.children;for(let o=0,r=s.length;o<r;o++)this.expandByObject(s[o],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Jn),Jn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(lr),jr.subVectors(this.max,lr),fo.subVectors(t.a,lr),po.subVectors(t.b,lr),mo.subVectors(t.c,lr),Ki.subVectors(po,fo),Zi.subVectors(mo,po),Ss.subVectors(fo,mo);let e=[0,-Ki.z,Ki.y,0,-Zi.z,Zi.y,0,-Ss.z,Ss.y,Ki.z,0,-Ki.x,Zi.z,0,-Zi.x,Ss.z,0,-Ss.x,-Ki.y,Ki.x,0,-Zi.y,Zi.x,0,-Ss.y,Ss.x,0];return!Ul(e,fo,po,mo,jr)||(e=[1,0,0,0,1,0,0,0,1],!Ul(e,fo,po,mo,jr))?!1:(Yr.crossVectors(Ki,Zi),e=[Yr.x,Yr.y,Yr.z],Ul(e,fo,po,mo,jr))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Jn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Jn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ci[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ci[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ci[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ci[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ci[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ci[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ci[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ci[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ci),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const Ci=[new et,new et,new et,new et,new et,new et,new et,new et],Jn=new et,Xr=new Rr,fo=new et,po=new et,mo=new et,Ki=new et,Zi=new et,Ss=new et,lr=new et,jr=new et,Yr=new et,ws=new et;function Ul(i,t,e,n,s){for(let o=0,r=i.length-3;o<=r;o+=3){ws.fromArray(i,o);const a=s.x*Math.abs(ws.x)+s.y*Math.abs(ws.y)+s.z*Math.abs(ws.z),l=t.dot(ws),c=e.dot(ws),h=n.dot(ws);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}const LC=new Rr,cr=new et,kl=new et;class Yh{constructor(t=new et,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):LC.setFromPoints(t).getCenter(n);let s=0;for(let o=0,r=t.length;o<r;o++)s=Math.max(s,n.distanceToSquared(t[o]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;cr.subVectors(t,this.center);const e=cr.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(cr,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(kl.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(cr.copy(t.center).add(kl)),this.expandByPoint(cr.copy(t.center).sub(kl))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Pi=new et,Fl=new et,Kr=new et,Ji=new et,Ol=new et,Zr=new et,Bl=new et;class Om{constructor(t=new et,e=new et(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Pi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Pi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Pi.copy(this.origin).addScaledVector(this.direction,e),Pi.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Fl.copy(t).add(e).multiplyScalar(.5),Kr.copy(e).sub(t).normalize(),Ji.copy(this.origin).sub(Fl);const o=t.distanceTo(e)*.5,r=-this.direction.dot(Kr),a=Ji.dot(this.direction),l=-Ji.dot(Kr),c=Ji.lengthSq(),h=Math.abs(1-r*r);let u,d,p,_;if(h>0)if(u=r*l-a,d=r*a-l,_=o*h,u>=0)if(d>=-_)if(d<=_){const g=1/h;u*=g,d*=g,p=u*(u+r*d+2*a)+d*(r*u+d+2*l)+c}else d=o,u=Math.max(0,-(r*d+a)),p=-u*u+d*(d+2*l)+c;else d=-o,u=Math.max(0,-(r*d+a)),p=-u*u+d*(d+2*l)+c;else d<=-_?(u=Math.max(0,-(-r*o+a)),d=u>0?-o:Math.min(Math.max(-o,-l),o),p=-u*u+d*(d+2*l)+c):d<=_?(u=0,d=Math.min(Math.max(-o,-l),o),p=d*(d+2*l)+c):(u=Math.max(0,-(r*o+a)),d=u>0?o:Math.min(Math.max(-o,-l),o),p=-u*u+d*(d+2*l)+c);else d=r>0?-o:o,u=Math.max(0,-(r*d+a)),p=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Fl).addScaledVector(Kr,d),p}intersectSphere(t,e){Pi.subVectors(t.center,this.origin);const n=Pi.dot(this.direction),s=Pi.dot(Pi)-n*n,o=t.radius*t.radius;if(s>o)return null;const r=Math.sqrt(o-s),a=n-r,l=n+r;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,o,r,a,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(o=(t.min.y-d.y)*h,r=(t.max.y-d.y)*h):(o=(t.max.y-d.y)*h,r=(t.min.y-d.y)*h),n>r||o>s||((o>n||isNaN(n))&&(n=o),(r<s||isNaN(s))&&(s=r),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Pi)!==null}intersectTriangle(t,e,n,s,o){Ol.subVectors(e,t),Zr.subVectors(n,t),Bl.crossVectors(Ol,Zr);let r=this.direction.dot(Bl),a;if(r>0){if(s)return null;a=1}else if(r<0)a=-1,r=-r;else return null;Ji.subVectors(this.origin,t);const l=a*this.direction.dot(Zr.crossVectors(Ji,Zr));if(l<0)return null;const c=a*this.direction.dot(Ol.cross(Ji));if(c<0||l+c>r)return null;const h=-a*Ji.dot(Bl);return h<0?null:this.at(h/r,o)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Ve{constructor(t,e,n,s,o,r,a,l,c,h,u,d,p,_,g,m){Ve.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,o,r,a,l,c,h,u,d,p,_,g,m)}set(t,e,n,s,o,r,a,l,c,h,u,d,p,_,g,m){const f=this.elements;return f[0]=t,f[4]=e,f[8]=n,f[12]=s,f[1]=o,f[5]=r,f[9]=a,f[13]=l,f[2]=c,f[6]=h,f[10]=u,f[14]=d,f[3]=p,f[7]=_,f[11]=g,f[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Ve().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,n=t.elements,s=1/go.setFromMatrixColumn(t,0).length(),o=1/go.setFromMatrixColumn(t,1).length(),r=1/go.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*o,e[5]=n[5]*o,e[6]=n[6]*o,e[7]=0,e[8]=n[8]*r,e[9]=n[9]*r,e[10]=n[10]*r,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,o=t.z,r=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(o),u=Math.sin(o);if(t.order==="XYZ"){const d=r*h,p=r*u,_=a*h,g=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=p+_*c,e[5]=d-g*c,e[9]=-a*l,e[2]=g-d*c,e[6]=_+p*c,e[10]=r*l}else if(t.order==="YXZ"){const d=l*h,p=l*u,_=c*h,g=c*u;e[0]=d+g*a,e[4]=_*a-p,e[8]=r*c,e[1]=r*u,e[5]=r*h,e[9]=-a,e[2]=p*a-_,e[6]=g+d*a,e[10]=r*l}else if(t.order==="ZXY"){const d=l*h,p=l*u,_=c*h,g=c*u;e[0]=d-g*a,e[4]=-r*u,e[8]=_+p*a,e[1]=p+_*a,e[5]=r*h,e[9]=g-d*a,e[2]=-r*c,e[6]=a,e[10]=r*l}else if(t.order==="ZYX"){const d=r*h,p=r*u,_=a*h,g=a*u;e[0]=l*h,e[4]=_*c-p,e[8]=d*c+g,e[1]=l*u,e[5]=g*c+d,e[9]=p*c-_,e[2]=-c,e[6]=a*l,e[10]=r*l}else if(t.order==="YZX"){const d=r*l,p=r*c,_=a*l,g=a*c;e[0]=l*h,e[4]=g-d*u,e[8]=_*u+p,e[1]=u,e[5]=r*h,e[9]=-a*h,e[2]=-c*h,e[6]=p*u+_,e[10]=d-g*u}else if(t.order==="XZY"){const d=r*l,p=r*c,_=a*l,g=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+g,e[5]=r*h,e[9]=p*u-_,e[2]=_*u-p,e[6]=a*h,e[10]=g*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(DC,t,IC)}lookAt(t,e,n){const s=this.elements;return kn.subVectors(t,e),kn.lengthSq()===0&&(kn.z=1),kn.normalize(),Qi.crossVectors(n,kn),Qi.lengthSq()===0&&(Math.abs(n.z)===1?kn.x+=1e-4:kn.z+=1e-4,kn.normalize(),Qi.crossVectors(n,kn)),Qi.normalize(),Jr.crossVectors(kn,Qi),s[0]=Qi.x,s[4]=Jr.x,s[8]=kn.x,s[1]=Qi.y,s[5]=Jr.y,s[9]=kn.y,s[2]=Qi.z,s[6]=Jr.z,s[10]=kn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,o=this.elements,r=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],p=n[13],_=n[2],g=n[6],m=n[10],f=n[14],M=n[3],S=n[7],x=n[11],k=n[15],P=s[0],A=s[4],I=s[8],E=s[12],b=s[1],R=s[5],H=s[9],O=s[13],q=s[2],$=s[6],X=s[10],j=s[14],Q=s[3],at=s[7],lt=s[11],gt=s[15];return o[0]=r*P+a*b+l*q+c*Q,o[4]=r*A+a*R+l*$+c*at,o[8]=r*I+a*H+l*X+c*lt,o[12]=r*E+a*O+l*j+c*gt,o[1]=h*P+u*b+d*q+p*Q,o[5]=h*A+u*R+d*$+p*at,o[9]=h*I+u*H+d*X+p*lt,o[13]=h*E+u*O+d*j+p*gt,o[2]=_*P+g*b+m*q+f*Q,o[6]=_*A+g*R+m*$+f*at,o[10]=_*I+g*H+m*X+f*lt,o[14]=_*E+g*O+m*j+f*gt,o[3]=M*P+S*b+x*q+k*Q,o[7]=M*A+S*R+x*$+k*at,o[11]=M*I+S*H+x*X+k*lt,o[15]=M*E+S*O+x*j+k*gt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],o=t[12],r=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],p=t[14],_=t[3],g=t[7],m=t[11],f=t[15];return _*(+o*l*u-s*c*u-o*a*d+n*c*d+s*a*p-n*l*p)+g*(+e*l*p-e*c*d+o*r*d-s*r*p+s*c*h-o*l*h)+m*(+e*c*u-e*a*p-o*r*u+n*r*p+o*a*h-n*c*h)+f*(-s*a*h-e*l*u+e*a*d+s*r*u-n*r*d+n*l*h)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],o=t[3],r=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],p=t[11],_=t[12],g=t[13],m=t[14],f=t[15],M=u*m*c-g*d*c+g*l*p-a*m*p-u*l*f+a*d*f,S=_*d*c-h*m*c-_*l*p+r*m*p+h*l*f-r*d*f,x=h*g*c-_*u*c+_*a*p-r*g*p-h*a*f+r*u*f,k=_*u*l-h*g*l-_*a*d+r*g*d+h*a*m-r*u*m,P=e*M+n*S+s*x+o*k;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const A=1/P;return t[0]=M*A,t[1]=(g*d*o-u*m*o-g*s*p+n*m*p+u*s*f-n*d*f)*A,t[2]=(a*m*o-g*l*o+g*s*c-n*m*c-a*s*f+n*l*f)*A,t[3]=(u*l*o-a*d*o-u*s*c+n*d*c+a*s*p-n*l*p)*A,t[4]=S*A,t[5]=(h*m*o-_*d*o+_*s*p-e*m*p-h*s*f+e*d*f)*A,t[6]=(_*l*o-r*m*o-_*s*c+e*m*c+r*s*f-e*l*f)*A,t[7]=(r*d*o-h*l*o+h*s*c-e*d*c-r*s*p+e*l*p)*A,t[8]=x*A,t[9]=(_*u*o-h*g*o-_*n*p+e*g*p+h*n*f-e*u*f)*A,t[10]=(r*g*o-_*a*o+_*n*c-e*g*c-r*n*f+e*a*f)*A,t[11]=(h*a*o-r*u*o-h*n*c+e*u*c+r*n*p-e*a*p)*A,t[12]=k*A,t[13]=(h*g*s-_*u*s+_*n*d-e*g*d-h*n*m+e*u*m)*A,t[14]=(_*a*s-r*g*s-_*n*l+e*g*l+r*n*m-e*a*m)*A,t[15]=(r*u*s-h*a*s+h*n*l-e*u*l-r*n*d+e*a*d)*A,this}scale(t){const e=this.elements,n=t.x,s=t.y,o=t.z;return e[0]*=n,e[4]*=s,e[8]*=o,e[1]*=n,e[5]*=s,e[9]*=o,e[2]*=n,e[6]*=s,e[10]*=o,e[3]*=n,e[7]*=s,e[11]*=o,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),o=1-n,r=t.x,a=t.y,l=t.z,c=o*r,h=o*a;return this.set(c*r+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*r,0,c*l-s*a,h*l+s*r,o*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,o,r){return this.set(1,n,o,0,t,1,r,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,o=e._x,r=e._y,a=e._z,l=e._w,c=o+o,h=r+r,u=a+a,d=o*c,p=o*h,_=o*u,g=r*h,m=r*u,f=a*u,M=l*c,S=l*h,x=l*u,k=n.x,P=n.y,A=n.z;return s[0]=(1-(g+f))*k,s[1]=(p+x)*k,s[2]=(_-S)*k,s[3]=0,s[4]=(p-x)*P,s[5]=(1-(d+f))*P,s[6]=(m+M)*P,s[7]=0,s[8]=(_+S)*A,s[9]=(m-M)*A,s[10]=(1-(d+g))*A,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;let o=go.set(s[0],s[1],s[2]).length();const r=go.set(s[4],s[5],s[6]).length(),a=go.set(s[8],s[9],s[10]).length();this.determinant()<0&&(o=-o),t.x=s[12],t.y=s[13],t.z=s[14],Qn.copy(this);const c=1/o,h=1/r,u=1/a;return Qn.elements[0]*=c,Qn.elements[1]*=c,Qn.elements[2]*=c,Qn.elements[4]*=h,Qn.elements[5]*=h,Qn.elements[6]*=h,Qn.elements[8]*=u,Qn.elements[9]*=u,Qn.elements[10]*=u,e.setFromRotationMatrix(Qn),n.x=o,n.y=r,n.z=a,this}makePerspective(t,e,n,s,o,r,a=Oi){const l=this.elements,c=2*o/(e-t),h=2*o/(n-s),u=(e+t)/(e-t),d=(n+s)/(n-s);let p,_;if(a===Oi)p=-(r+o)/(r-o),_=-2*r*o/(r-o);else if(a===Fa)p=-r/(r-o),_=-r*o/(r-o);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,o,r,a=Oi){const l=this.elements,c=1/(e-t),h=1/(n-s),u=1/(r-o),d=(e+t)*c,p=(n+s)*h;let _,g;if(a===Oi)_=(r+o)*u,g=-2*u;else if(a===Fa)_=o*u,g=-1*u;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-d,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-p,l[2]=0,l[6]=0,l[10]=g,l[14]=-_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const go=new et,Qn=new Ve,DC=new et(0,0,0),IC=new et(1,1,1),Qi=new et,Jr=new et,kn=new et,rf=new Ve,af=new Ar;class wi{constructor(t=0,e=0,n=0,s=wi.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,o=s[0],r=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(Pn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-r,o)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Pn(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,o),this._z=0);break;case"ZXY":this._x=Math.asin(Pn(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-r,c)):(this._y=0,this._z=Math.atan2(l,o));break;case"ZYX":this._y=Math.asin(-Pn(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,p),this._z=Math.atan2(l,o)):(this._x=0,this._z=Math.atan2(-r,c));break;case"YZX":this._z=Math.asin(Pn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,o)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-Pn(r,-1,1)),Math.abs(r)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,o)):(this._x=Math.atan2(-h,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return rf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(rf,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return af.setFromEuler(this),this.setFromQuaternion(af,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}wi.DEFAULT_ORDER="XYZ";class Kh{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let NC=0;const lf=new et,_o=new Ar,Li=new Ve,Qr=new et,hr=new et,UC=new et,kC=new Ar,cf=new et(1,0,0),hf=new et(0,1,0),uf=new et(0,0,1),df={type:"added"},FC={type:"removed"},vo={type:"childadded",child:null},zl={type:"childremoved",child:null};class pn extends Zo{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:NC++}),this.uuid=Tr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=pn.DEFAULT_UP.clone();const t=new et,e=new wi,n=new Ar,s=new et(1,1,1);function o(){n.setFromEuler(e,!1)}function r(){e.setFromQuaternion(n,void 0,!1)}e._onChange(o),n._onChange(r),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ve},normalMatrix:{value:new ee}}),this.matrix=new Ve,this.matrixWorld=new Ve,this.matrixAutoUpdate=pn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=pn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Kh,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return _o.setFromAxisAngle(t,e),this.quaternion.multiply(_o),this}rotateOnWorldAxis(t,e){return _o.setFromAxisAngle(t,e),this.quaternion.premultiply(_o),this}rotateX(t){return this.rotateOnAxis(cf,t)}rotateY(t){return this.rotateOnAxis(hf,t)}rotateZ(t){return this.rotateOnAxis(uf,t)}translateOnAxis(t,e){return lf.copy(t).applyQuaternion(this.quaternion),this.position.add(lf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(cf,t)}translateY(t){return this.translateOnAxis(hf,t)}translateZ(t){return this.translateOnAxis(uf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Li.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Qr.copy(t):Qr.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),hr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Li.lookAt(hr,Qr,this.up):Li.lookAt(Qr,hr,this.up),this.quaternion.setFromRotationMatrix(Li),s&&(Li.extractRotation(s.matrixWorld),_o.setFromRotationMatrix(Li),this.quaternion.premultiply(_o.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(df),vo.child=t,this.dispatchEvent(vo),vo.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(FC),zl.child=t,this.dispatchEvent(zl),zl.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Li.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Li.multiply(t.parent.matrixWorld)),t.applyMatrix4(Li),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(df),vo.child=t,this.dispatchEvent(vo),vo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const r=this.children[n].getObjectByProperty(t,e);if(r!==void 0)return r}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let o=0,r=s.length;o<r;o++)s[o].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(hr,t,UC),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(hr,kC,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){const n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let o=0,r=s.length;o<r;o++)s[o].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function o(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=o(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];o(t.shapes,u)}else o(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(o(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(o(t.materials,this.material[l]));s.material=a}else s.material=o(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(o(t.animations,l))}}if(e){const a=r(t.geometries),l=r(t.materials),c=r(t.textures),h=r(t.images),u=r(t.shapes),d=r(t.skeletons),p=r(t.animations),_=r(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),p.length>0&&(n.animations=p),_.length>0&&(n.nodes=_)}return n.object=s,n;function r(a){const l=[];for(const c in a){const h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}}pn.DEFAULT_UP=new et(0,1,0);pn.DEFAULT_MATRIX_AUTO_UPDATE=!0;pn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const ti=new et,Di=new et,Hl=new et,Ii=new et,xo=new et,bo=new et,ff=new et,Vl=new et,Gl=new et,Wl=new et,$l=new $e,ql=new $e,Xl=new $e;class ri{constructor(t=new et,e=new et,n=new et){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),ti.subVectors(t,e),s.cross(ti);const o=s.lengthSq();return o>0?s.multiplyScalar(1/Math.sqrt(o)):s.set(0,0,0)}static getBarycoord(t,e,n,s,o){ti.subVectors(s,e),Di.subVectors(n,e),Hl.subVectors(t,e);const r=ti.dot(ti),a=ti.dot(Di),l=ti.dot(Hl),c=Di.dot(Di),h=Di.dot(Hl),u=r*c-a*a;if(u===0)return o.set(0,0,0),null;const d=1/u,p=(c*l-a*h)*d,_=(r*h-a*l)*d;return o.set(1-p-_,_,p)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Ii)===null?!1:Ii.x>=0&&Ii.y>=0&&Ii.x+Ii.y<=1}static getInterpolation(t,e,n,s,o,r,a,l){return this.getBarycoord(t,e,n,s,Ii)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(o,Ii.x),l.addScaledVector(r,Ii.y),l.addScaledVector(a,Ii.z),l)}static getInterpolatedAttribute(t,e,n,s,o,r){return $l.setScalar(0),ql.setScalar(0),Xl.setScalar(0),$l.fromBufferAttribute(t,e),ql.fromBufferAttribute(t,n),Xl.fromBufferAttribute(t,s),r.setScalar(0),r.addScaledVector($l,o.x),r.addScaledVector(ql,o.y),r.addScaledVector(Xl,o.z),r}static isFrontFacing(t,e,n,s){return ti.subVectors(n,e),Di.subVectors(t,e),ti.cross(Di).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return ti.subVectors(this.c,this.b),Di.subVectors(this.a,this.b),ti.cross(Di).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return ri.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return ri.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,o){return ri.getInterpolation(t,this.a,this.b,this.c,e,n,s,o)}containsPoint(t){return ri.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return ri.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,o=this.c;let r,a;xo.subVectors(s,n),bo.subVectors(o,n),Vl.subVectors(t,n);const l=xo.dot(Vl),c=bo.dot(Vl);if(l<=0&&c<=0)return e.copy(n);Gl.subVectors(t,s);const h=xo.dot(Gl),u=bo.dot(Gl);if(h>=0&&u<=h)return e.copy(s);const d=l*u-h*c;if(d<=0&&l>=0&&h<=0)return r=l/(l-h),e.copy(n).addScaledVector(xo,r);Wl.subVectors(t,o);const p=xo.dot(Wl),_=bo.dot(Wl);if(_>=0&&p<=_)return e.copy(o);const g=p*c-l*_;if(g<=0&&c>=0&&_<=0)return a=c/(c-_),e.copy(n).addScaledVector(bo,a);const m=h*_-p*u;if(m<=0&&u-h>=0&&p-_>=0)return ff.subVectors(o,s),a=(u-h)/(u-h+(p-_)),e.copy(s).addScaledVector(ff,a);const f=1/(m+g+d);return r=g*f,a=d*f,e.copy(n).addScaledVector(xo,r).addScaledVector(bo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const Bm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ts={h:0,s:0,l:0},ta={h:0,s:0,l:0};function jl(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class pe{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Bn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.toWorkingColorSpace(this,e),this}setRGB(t,e,n,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=n,ve.toWorkingColorSpace(this,s),this}setHSL(t,e,n,s=ve.workingColorSpace){if(t=yC(t,1),e=Pn(e,0,1),n=Pn(n,0,1),e===0)this.r=this.g=this.b=n;else{const o=n<=.5?n*(1+e):n+e-n*e,r=2*n-o;this.r=jl(r,o,t+1/3),this.g=jl(r,o,t),this.b=jl(r,o,t-1/3)}return ve.toWorkingColorSpace(this,s),this}setStyle(t,e=Bn){function n(o){o!==void 0&&parseFloat(o)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let o;const r=s[1],a=s[2];switch(r){case"rgb":case"rgba":if(o=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(o[4]),this.setRGB(Math.min(255,parseInt(o[1],10))/255,Math.min(255,parseInt(o[2],10))/255,Math.min(255,parseInt(o[3],10))/255,e);if(o=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(o[4]),this.setRGB(Math.min(100,parseInt(o[1],10))/100,Math.min(100,parseInt(o[2],10))/100,Math.min(100,parseInt(o[3],10))/100,e);break;case"hsl":case"hsla":if(o=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(o[4]),this.setHSL(parseFloat(o[1])/360,parseFloat(o[2])/100,parseFloat(o[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const o=s[1],r=o.length;if(r===3)return this.setRGB(parseInt(o.charAt(0),16)/15,parseInt(o.charAt(1),16)/15,parseInt(o.charAt(2),16)/15,e);if(r===6)return this.setHex(parseInt(o,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Bn){const n=Bm[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Vi(t.r),this.g=Vi(t.g),this.b=Vi(t.b),this}copyLinearToSRGB(t){return this.r=Io(t.r),this.g=Io(t.g),this.b=Io(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Bn){return ve.fromWorkingColorSpace(vn.copy(this),t),Math.round(Pn(vn.r*255,0,255))*65536+Math.round(Pn(vn.g*255,0,255))*256+Math.round(Pn(vn.b*255,0,255))}getHexString(t=Bn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.fromWorkingColorSpace(vn.copy(this),e);const n=vn.r,s=vn.g,o=vn.b,r=Math.max(n,s,o),a=Math.min(n,s,o);let l,c;const h=(a+r)/2;if(a===r)l=0,c=0;else{const u=r-a;switch(c=h<=.5?u/(r+a):u/(2-r-a),r){case n:l=(s-o)/u+(s<o?6:0);break;case s:l=(o-n)/u+2;break;case o:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ve.workingColorSpace){return ve.fromWorkingColorSpace(vn.copy(this),e),t.r=vn.r,t.g=vn.g,t.b=vn.b,t}getStyle(t=Bn){ve.fromWorkingColorSpace(vn.copy(this),t);const e=vn.r,n=vn.g,s=vn.b;return t!==Bn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(ts),this.setHSL(ts.h+t,ts.s+e,ts.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(ts),t.getHSL(ta);const n=Ll(ts.h,ta.h,e),s=Ll(ts.s,ta.s,e),o=Ll(ts.l,ta.l,e);return this.setHSL(n,s,o),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,o=t.elements;return this.r=o[0]*e+o[3]*n+o[6]*s,this.g=o[1]*e+o[4]*n+o[7]*s,this.b=o[2]*e+o[5]*n+o[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const vn=new pe;pe.NAMES=Bm;let OC=0;class Cr extends Zo{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:OC++}),this.uuid=Tr(),this.name="",this.blending=Lo,this.side=fs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ac,this.blendDst=Rc,this.blendEquation=Us,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new pe(0,0,0),this.blendAlpha=0,this.depthFunc=Bo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Yd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ho,this.stencilZFail=ho,this.stencilZPass=ho,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==Lo&&(n.blending=this.blending),this.side!==fs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Ac&&(n.blendSrc=this.blendSrc),this.blendDst!==Rc&&(n.blendDst=this.blendDst),this.blendEquation!==Us&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==Bo&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Yd&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==ho&&(n.stencilFail=this.stencilFail),this.stencilZFail!==ho&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==ho&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(o){const r=[];for(const a in o){const l=o[a];delete l.metadata,r.push(l)}return r}if(e){const o=s(t.textures),r=s(t.images);o.length>0&&(n.textures=o),r.length>0&&(n.images=r)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let o=0;o!==s;++o)n[o]=e[o].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class Zh extends Cr{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new pe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.combine=ym,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const Xe=new et,ea=new xe;class Mi{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Kd,this.updateRanges=[],this.gpuType=Fi,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,o=this.itemSize;s<o;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)ea.fromBufferAttribute(this,e),ea.applyMatrix3(t),this.setXY(e,ea.x,ea.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Xe.fromBufferAttribute(this,e),Xe.applyMatrix3(t),this.setXYZ(e,Xe.x,Xe.y,Xe.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Xe.fromBufferAttribute(this,e),Xe.applyMatrix4(t),this.setXYZ(e,Xe.x,Xe.y,Xe.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Xe.fromBufferAttribute(this,e),Xe.applyNormalMatrix(t),this.setXYZ(e,Xe.x,Xe.y,Xe.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Xe.fromBufferAttribute(this,e),Xe.transformDirection(t),this.setXYZ(e,Xe.x,Xe.y,Xe.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=ar(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Cn(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=ar(e,this.array)),e}setX(t,e){return this.normalized&&(e=Cn(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=ar(e,this.array)),e}setY(t,e){return this.normalized&&(e=Cn(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=ar(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Cn(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=ar(e,this.array)),e}setW(t,e){return this.normalized&&(e=Cn(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Cn(e,this.array),n=Cn(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Cn(e,this.array),n=Cn(n,this.array),s=Cn(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,o){return t*=this.itemSize,this.normalized&&(e=Cn(e,this.array),n=Cn(n,this.array),s=Cn(s,this.array),o=Cn(o,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=o,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Kd&&(t.usage=this.usage),t}}class zm extends Mi{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class Hm extends Mi{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class Si extends Mi{constructor(t,e,n){super(new Float32Array(t),e,n)}}let BC=0;const $n=new Ve,Yl=new pn,yo=new et,Fn=new Rr,ur=new Rr,hn=new et;class ms extends Zo{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:BC++}),this.uuid=Tr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Um(t)?Hm:zm)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const o=new ee().getNormalMatrix(t);n.applyNormalMatrix(o),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return $n.makeRotationFromQuaternion(t),this.applyMatrix4($n),this}rotateX(t){return $n.makeRotationX(t),this.applyMatrix4($n),this}rotateY(t){return $n.makeRotationY(t),this.applyMatrix4($n),this}rotateZ(t){return $n.makeRotationZ(t),this.applyMatrix4($n),this}translate(t,e,n){return $n.makeTranslation(t,e,n),this.applyMatrix4($n),this}scale(t,e,n){return $n.makeScale(t,e,n),this.applyMatrix4($n),this}lookAt(t){return Yl.lookAt(t),Yl.updateMatrix(),this.applyMatrix4(Yl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(yo).negate(),this.translate(yo.x,yo.y,yo.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,o=t.length;s<o;s++){const r=t[s];n.push(r.x,r.y,r.z||0)}this.setAttribute("position",new Si(n,3))}else{for(let n=0,s=e.count;n<s;n++){const o=t[n];e.setXYZ(n,o.x,o.y,o.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Rr);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new et(-1/0,-1/0,-1/0),new et(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const o=e[n];Fn.setFromBufferAttribute(o),this.morphTargetsRelative?(hn.addVectors(this.boundingBox.min,Fn.min),this.boundingBox.expandByPoint(hn),hn.addVectors(this.boundingBox.max,Fn.max),this.boundingBox.expandByPoint(hn)):(this.boundingBox.expandByPoint(Fn.min),this.boundingBox.expandByPoint(Fn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Yh);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new et,1/0);return}if(t){const n=this.boundingSphere.center;if(Fn.setFromBufferAttribute(t),e)for(let o=0,r=e.length;o<r;o++){const a=e[o];ur.setFromBufferAttribute(a),this.morphTargetsRelative?(hn.addVectors(Fn.min,ur.min),Fn.expandByPoint(hn),hn.addVectors(Fn.max,ur.max),Fn.expandByPoint(hn)):(Fn.expandByPoint(ur.min),Fn.expandByPoint(ur.max))}Fn.getCenter(n);let s=0;for(let o=0,r=t.count;o<r;o++)hn.fromBufferAttribute(t,o),s=Math.max(s,n.distanceToSquared(hn));if(e)for(let o=0,r=e.length;o<r;o++){const a=e[o],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)hn.fromBufferAttribute(a,c),l&&(yo.fromBufferAttribute(t,c),hn.add(yo)),s=Math.max(s,n.distanceToSquared(hn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,o=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Mi(new Float32Array(4*n.count),4));const r=this.getAttribute("tangent"),a=[],l=[];for(let I=0;I<n.count;I++)a[I]=new et,l[I]=new et;const c=new et,h=new et,u=new et,d=new xe,p=new xe,_=new xe,g=new et,m=new et;function f(I,E,b){c.fromBufferAttribute(n,I),h.fromBufferAttribute(n,E),u.fromBufferAttribute(n,b),d.fromBufferAttribute(o,I),p.fromBufferAttribute(o,E),_.fromBufferAttribute(o,b),h.sub(c),u.sub(c),p.sub(d),_.sub(d);const R=1/(p.x*_.y-_.x*p.y);isFinite(R)&&(g.copy(h).multiplyScalar(_.y).addScaledVector(u,-p.y).multiplyScalar(R),m.copy(u).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(R),a[I].add(g),a[E].add(g),a[b].add(g),l[I].add(m),l[E].add(m),l[b].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let I=0,E=M.length;I<E;++I){const b=M[I],R=b.start,H=b.count;for(let O=R,q=R+H;O<q;O+=3)f(t.getX(O+0),t.getX(O+1),t.getX(O+2))}const S=new et,x=new et,k=new et,P=new et;function A(I){k.fromBufferAttribute(s,I),P.copy(k);const E=a[I];S.copy(E),S.sub(k.multiplyScalar(k.dot(E))).normalize(),x.crossVectors(P,E);const R=x.dot(l[I])<0?-1:1;r.setXYZW(I,S.x,S.y,S.z,R)}for(let I=0,E=M.length;I<E;++I){const b=M[I],R=b.start,H=b.count;for(let O=R,q=R+H;O<q;O+=3)A(t.getX(O+0)),A(t.getX(O+1)),A(t.getX(O+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Mi(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,p=n.count;d<p;d++)n.setXYZ(d,0,0,0);const s=new et,o=new et,r=new et,a=new et,l=new et,c=new et,h=new et,u=new et;if(t)for(let d=0,p=t.count;d<p;d+=3){const _=t.getX(d+0),g=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,_),o.fromBufferAttribute(e,g),r.fromBufferAttribute(e,m),h.subVectors(r,o),u.subVectors(s,o),h.cross(u),a.fromBufferAttribute(n,_),l.fromBufferAttribute(n,g),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(_,a.x,a.y,a.z),n.setXYZ(g,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,p=e.count;d<p;d+=3)s.fromBufferAttribute(e,d+0),o.fromBufferAttribute(e,d+1),r.fromBufferAttribute(e,d+2),h.subVectors(r,o),u.subVectors(s,o),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)hn.fromBufferAttribute(t,e),hn.normalize(),t.setXYZ(e,hn.x,hn.y,hn.z)}toNonIndexed(){function t(a,l){const c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h);let p=0,_=0;for(let g=0,m=l.length;g<m;g++){a.isInterleavedBufferAttribute?p=l[g]*a.data.stride+a.offset:p=l[g]*h;for(let f=0;f<h;f++)d[_++]=c[p++]}return new Mi(d,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new ms,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,n);e.setAttribute(a,c)}const o=this.morphAttributes;for(const a in o){const l=[],c=o[a];for(let h=0,u=c.length;h<u;h++){const d=c[h],p=t(d,n);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const r=this.groups;for(let a=0,l=r.length;a<l;a++){const c=r[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let o=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){const p=c[u];h.push(p.toJSON(t.data))}h.length>0&&(s[l]=h,o=!0)}o&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const r=this.groups;r.length>0&&(t.data.groups=JSON.parse(JSON.stringify(r)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone(e));const s=t.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(e))}const o=t.morphAttributes;for(const c in o){const h=[],u=o[c];for(let d=0,p=u.length;d<p;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;const r=t.groups;for(let c=0,h=r.length;c<h;c++){const u=r[c];this.addGroup(u.start,u.count,u.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const pf=new Ve,Es=new Om,na=new Yh,mf=new et,ia=new et,sa=new et,oa=new et,Kl=new et,ra=new et,gf=new et,aa=new et;class fn extends pn{constructor(t=new ms,e=new Zh){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,r=s.length;o<r;o++){const a=s[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=o}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,o=n.morphAttributes.position,r=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(o&&a){ra.set(0,0,0);for(let l=0,c=o.length;l<c;l++){const h=a[l],u=o[l];h!==0&&(Kl.fromBufferAttribute(u,t),r?ra.addScaledVector(Kl,h):ra.addScaledVector(Kl.sub(e),h))}e.add(ra)}return e}raycast(t,e){const n=this.geometry,s=this.material,o=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),na.copy(n.boundingSphere),na.applyMatrix4(o),Es.copy(t.ray).recast(t.near),!(na.containsPoint(Es.origin)===!1&&(Es.intersectSphere(na,mf)===null||Es.origin.distanceToSquared(mf)>(t.far-t.near)**2))&&(pf.copy(o).invert(),Es.copy(t.ray).applyMatrix4(pf),!(n.boundingBox!==null&&Es.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Es)))}_computeIntersections(t,e,n){let s;const o=this.geometry,r=this.material,a=o.index,l=o.attributes.position,c=o.attributes.uv,h=o.attributes.uv1,u=o.attributes.normal,d=o.groups,p=o.drawRange;if(a!==null)if(Array.isArray(r))for(let _=0,g=d.length;_<g;_++){const m=d[_],f=r[m.materialIndex],M=Math.max(m.start,p.start),S=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let x=M,k=S;x<k;x+=3){const P=a.getX(x),A=a.getX(x+1),I=a.getX(x+2);s=la(this,f,t,n,c,h,u,P,A,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const _=Math.max(0,p.start),g=Math.min(a.count,p.start+p.count);for(let m=_,f=g;m<f;m+=3){const M=a.getX(m),S=a.getX(m+1),x=a.getX(m+2);s=la(this,r,t,n,c,h,u,M,S,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(r))for(let _=0,g=d.length;_<g;_++){const m=d[_],f=r[m.materialIndex],M=Math.max(m.start,p.start),S=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let x=M,k=S;x<k;x+=3){const P=x,A=x+1,I=x+2;s=la(this,f,t,n,c,h,u,P,A,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const _=Math.max(0,p.start),g=Math.min(l.count,p.start+p.count);for(let m=_,f=g;m<f;m+=3){const M=m,S=m+1,x=m+2;s=la(this,r,t,n,c,h,u,M,S,x),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function zC(i,t,e,n,s,o,r,a){let l;if(t.side===Ln?l=n.intersectTriangle(r,o,s,!0,a):l=n.intersectTriangle(s,o,r,t.side===fs,a),l===null)return null;aa.copy(a),aa.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(aa);return c<e.near||c>e.far?null:{distance:c,point:aa.clone(),object:i}}function la(i,t,e,n,s,o,r,a,l,c){i.getVertexPosition(a,ia),i.getVertexPosition(l,sa),i.getVertexPosition(c,oa);const h=zC(i,t,e,n,ia,sa,oa,gf);if(h){const u=new et;ri.getBarycoord(gf,ia,sa,oa,u),s&&(h.uv=ri.getInterpolatedAttribute(s,a,l,c,u,new xe)),o&&(h.uv1=ri.getInterpolatedAttribute(o,a,l,c,u,new xe)),r&&(h.normal=ri.getInterpolatedAttribute(r,a,l,c,u,new et),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const d={a,b:l,c,normal:new et,materialIndex:0};ri.getNormal(ia,sa,oa,d.normal),h.face=d,h.barycoord=u}return h}class js extends ms{constructor(t=1,e=1,n=1,s=1,o=1,r=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:o,depthSegments:r};const a=this;s=Math.floor(s),o=Math.floor(o),r=Math.floor(r);const l=[],c=[],h=[],u=[];let d=0,p=0;_("z","y","x",-1,-1,n,e,t,r,o,0),_("z","y","x",1,-1,n,e,-t,r,o,1),_("x","z","y",1,1,t,n,e,s,r,2),_("x","z","y",1,-1,t,n,-e,s,r,3),_("x","y","z",1,-1,t,e,n,s,o,4),_("x","y","z",-1,-1,t,e,-n,s,o,5),this.setIndex(l),this.setAttribute("position",new Si(c,3)),this.setAttribute("normal",new Si(h,3)),this.setAttribute("uv",new Si(u,2));function _(g,m,f,M,S,x,k,P,A,I,E){const b=x/A,R=k/I,H=x/2,O=k/2,q=P/2,$=A+1,X=I+1;let j=0,Q=0;const at=new et;for(let lt=0;lt<X;lt++){const gt=lt*R-O;for(let xt=0;xt<$;xt++){const mt=xt*b-H;at[g]=mt*M,at[m]=gt*S,at[f]=q,c.push(at.x,at.y,at.z),at[g]=0,at[m]=0,at[f]=P>0?1:-1,h.push(at.x,at.y,at.z),u.push(xt/A),u.push(1-lt/I),j+=1}}for(let lt=0;lt<I;lt++)for(let gt=0;gt<A;gt++){const xt=d+gt+$*lt,mt=d+gt+$*(lt+1),ot=d+(gt+1)+$*(lt+1),ut=d+(gt+1)+$*lt;l.push(xt,mt,ut),l.push(mt,ot,ut),Q+=6}a.addGroup(p,Q,E),p+=Q,d+=j}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new js(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function Wo(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function wn(i){const t={};for(let e=0;e<i.length;e++){const n=Wo(i[e]);for(const s in n)t[s]=n[s]}return t}function HC(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Vm(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}const VC={clone:Wo,merge:wn};var GC=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,WC=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class ps extends Cr{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=GC,this.fragmentShader=WC,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Wo(t.uniforms),this.uniformsGroups=HC(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const r=this.uniforms[s].value;r&&r.isTexture?e.uniforms[s]={type:"t",value:r.toJSON(t).uuid}:r&&r.isColor?e.uniforms[s]={type:"c",value:r.getHex()}:r&&r.isVector2?e.uniforms[s]={type:"v2",value:r.toArray()}:r&&r.isVector3?e.uniforms[s]={type:"v3",value:r.toArray()}:r&&r.isVector4?e.uniforms[s]={type:"v4",value:r.toArray()}:r&&r.isMatrix3?e.uniforms[s]={type:"m3",value:r.toArray()}:r&&r.isMatrix4?e.uniforms[s]={type:"m4",value:r.toArray()}:e.uniforms[s]={value:r}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}}class Gm extends pn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ve,this.projectionMatrix=new Ve,this.projectionMatrixInverse=new Ve,this.coordinateSystem=Oi}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const es=new et,_f=new xe,vf=new xe;class jn extends Gm{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=uh*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(Pl*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return uh*2*Math.atan(Math.tan(Pl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){es.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(es.x,es.y).multiplyScalar(-t/es.z),es.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(es.x,es.y).multiplyScalar(-t/es.z)}getViewSize(t,e){return this.getViewBounds(t,_f,vf),e.subVectors(vf,_f)}setViewOffset(t,e,n,s,o,r){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(Pl*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,o=-.5*s;const r=this.view;if(this.view!==null&&this.view.enabled){const l=r.fullWidth,c=r.fullHeight;o+=r.offsetX*s/l,e-=r.offsetY*n/c,s*=r.width/l,n*=r.height/c}const a=this.filmOffset;a!==0&&(o+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(o,o+s,e,e-n,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const Mo=-90,So=1;class $C extends pn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new jn(Mo,So,t,e);s.layers=this.layers,this.add(s);const o=new jn(Mo,So,t,e);o.layers=this.layers,this.add(o);const r=new jn(Mo,So,t,e);r.layers=this.layers,this.add(r);const a=new jn(Mo,So,t,e);a.layers=this.layers,this.add(a);const l=new jn(Mo,So,t,e);l.layers=this.layers,this.add(l);const c=new jn(Mo,So,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,o,r,a,l]=e;for(const c of e)this.remove(c);if(t===Oi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),o.up.set(0,0,-1),o.lookAt(0,1,0),r.up.set(0,0,1),r.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Fa)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),o.up.set(0,0,1),o.lookAt(0,1,0),r.up.set(0,0,-1),r.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[o,r,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;const g=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,o),t.setRenderTarget(n,1,s),t.render(e,r),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=g,t.setRenderTarget(n,5,s),t.render(e,h),t.setRenderTarget(u,d,p),t.xr.enabled=_,n.texture.needsPMREMUpdate=!0}}class Wm extends Tn{constructor(t,e,n,s,o,r,a,l,c,h){t=t!==void 0?t:[],e=e!==void 0?e:zo,super(t,e,n,s,o,r,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class qC extends Xs{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Wm(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:xi}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new js(5,5,5),o=new ps({name:"CubemapFromEquirect",uniforms:Wo(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Ln,blending:as});o.uniforms.tEquirect.value=e;const r=new fn(s,o),a=e.minFilter;return e.minFilter===Os&&(e.minFilter=xi),new $C(1,10,this).update(t,r),e.minFilter=a,r.geometry.dispose(),r.material.dispose(),this}clear(t,e,n,s){const o=t.getRenderTarget();for(let r=0;r<6;r++)t.setRenderTarget(this,r),t.clear(e,n,s);t.setRenderTarget(o)}}const Zl=new et,XC=new et,jC=new ee;class ss{constructor(t=new et(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=Zl.subVectors(n,e).cross(XC.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const n=t.delta(Zl),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const o=-(t.start.dot(this.normal)+this.constant)/s;return o<0||o>1?null:e.copy(t.start).addScaledVector(n,o)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||jC.getNormalMatrix(t),s=this.coplanarPoint(Zl).applyMatrix4(t),o=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(o),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Ts=new Yh,ca=new et;class Jh{constructor(t=new ss,e=new ss,n=new ss,s=new ss,o=new ss,r=new ss){this.planes=[t,e,n,s,o,r]}set(t,e,n,s,o,r){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(o),a[5].copy(r),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Oi){const n=this.planes,s=t.elements,o=s[0],r=s[1],a=s[2],l=s[3],c=s[4],h=s[5],u=s[6],d=s[7],p=s[8],_=s[9],g=s[10],m=s[11],f=s[12],M=s[13],S=s[14],x=s[15];if(n[0].setComponents(l-o,d-c,m-p,x-f).normalize(),n[1].setComponents(l+o,d+c,m+p,x+f).normalize(),n[2].setComponents(l+r,d+h,m+_,x+M).normalize(),n[3].setComponents(l-r,d-h,m-_,x-M).normalize(),n[4].setComponents(l-a,d-u,m-g,x-S).normalize(),e===Oi)n[5].setComponents(l+a,d+u,m+g,x+S).normalize();else if(e===Fa)n[5].setComponents(a,u,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ts.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ts.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ts)}intersectsSprite(t){return Ts.center.set(0,0,0),Ts.radius=.7071067811865476,Ts.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ts)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let o=0;o<6;o++)if(e[o].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(ca.x=s.normal.x>0?t.max.x:t.min.x,ca.y=s.normal.y>0?t.max.y:t.min.y,ca.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ca)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function $m(){let i=null,t=!1,e=null,n=null;function s(o,r){e(o,r),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(o){e=o},setContext:function(o){i=o}}}function YC(i){const t=new WeakMap;function e(a,l){const c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){const h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((p,_)=>p.start-_.start);let d=0;for(let p=1;p<u.length;p++){const _=u[d],g=u[p];g.start<=_.start+_.count+1?_.count=Math.max(_.count,g.start+g.count-_.start):(++d,u[d]=g)}u.length=d+1;for(let p=0,_=u.length;p<_;p++){const g=u[p];i.bufferSubData(c,g.start*h.BYTES_PER_ELEMENT,h,g.start,g.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function o(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function r(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:o,update:r}}class Pr extends ms{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const o=t/2,r=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,p=[],_=[],g=[],m=[];for(let f=0;f<h;f++){const M=f*d-r;for(let S=0;S<c;S++){const x=S*u-o;_.push(x,-M,0),g.push(0,0,1),m.push(S/a),m.push(1-f/l)}}for(let f=0;f<l;f++)for(let M=0;M<a;M++){const S=M+c*f,x=M+c*(f+1),k=M+1+c*(f+1),P=M+1+c*f;p.push(S,x,P),p.push(x,k,P)}this.setIndex(p),this.setAttribute("position",new Si(_,3)),this.setAttribute("normal",new Si(g,3)),this.setAttribute("uv",new Si(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Pr(t.width,t.height,t.widthSegments,t.heightSegments)}}var KC=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ZC=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,JC=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,QC=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,t2=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,e2=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,n2=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,i2=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,s2=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,o2=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,r2=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,a2=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,l2=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,c2=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,h2=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,u2=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,d2=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,f2=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,p2=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,m2=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,g2=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,_2=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,v2=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,x2=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,b2=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,y2=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,M2=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,S2=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,w2=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,E2=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,T2="gl_FragColor = linearToOutputTexel( gl_FragColor );",A2=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,R2=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,C2=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,P2=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,L2=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,D2=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,I2=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,N2=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,U2=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,k2=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,F2=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,O2=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,B2=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,z2=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,H2=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,V2=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,G2=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,W2=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,$2=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,q2=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,X2=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,j2=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Y2=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,K2=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Z2=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,J2=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Q2=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,tP=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,eP=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,nP=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,iP=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,sP=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,oP=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,rP=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,aP=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,lP=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,cP=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,hP=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,uP=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,dP=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,fP=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,pP=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,mP=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,gP=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_P=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,vP=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,xP=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,bP=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,yP=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,MP=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,SP=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,wP=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,EP=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,TP=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,AP=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,RP=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,CP=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,PP=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,LP=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,DP=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,IP=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,NP=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,UP=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,kP=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,FP=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,OP=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,BP=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,zP=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,HP=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,VP=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,GP=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,WP=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,$P=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,qP=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,XP=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,jP=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const YP=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,KP=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ZP=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,JP=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,QP=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,tL=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eL=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,nL=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,iL=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,sL=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,oL=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,rL=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aL=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,lL=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cL=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,hL=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,uL=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,dL=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fL=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,pL=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mL=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,gL=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,_L=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,vL=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xL=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,bL=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yL=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ML=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,SL=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,wL=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,EL=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,TL=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,AL=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,RL=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,se={alphahash_fragment:KC,alphahash_pars_fragment:ZC,alphamap_fragment:JC,alphamap_pars_fragment:QC,alphatest_fragment:t2,alphatest_pars_fragment:e2,aomap_fragment:n2,aomap_pars_fragment:i2,batching_pars_vertex:s2,batching_vertex:o2,begin_vertex:r2,beginnormal_vertex:a2,bsdfs:l2,iridescence_fragment:c2,bumpmap_pars_fragment:h2,clipping_planes_fragment:u2,clipping_planes_pars_fragment:d2,clipping_planes_pars_vertex:f2,clipping_planes_vertex:p2,color_fragment:m2,color_pars_fragment:g2,color_pars_vertex:_2,color_vertex:v2,common:x2,cube_uv_reflection_fragment:b2,defaultnormal_vertex:y2,displacementmap_pars_vertex:M2,displacementmap_vertex:S2,emissivemap_fragment:w2,emissivemap_pars_fragment:E2,colorspace_fragment:T2,colorspace_pars_fragment:A2,envmap_fragment:R2,envmap_common_pars_fragment:C2,envmap_pars_fragment:P2,envmap_pars_vertex:L2,envmap_physical_pars_fragment:V2,envmap_vertex:D2,fog_vertex:I2,fog_pars_vertex:N2,fog_fragment:U2,fog_pars_fragment:k2,gradientmap_pars_fragment:F2,lightmap_pars_fragment:O2,lights_lambert_fragment:B2,lights_lambert_pars_fragment:z2,lights_pars_begin:H2,lights_toon_fragment:G2,lights_toon_pars_fragment:W2,lights_phong_fragment:$2,lights_phong_pars_fragment:q2,lights_physical_fragment:X2,lights_physical_pars_fragment:j2,lights_fragment_begin:Y2,lights_fragment_maps:K2,lights_fragment_end:Z2,logdepthbuf_fragment:J2,logdepthbuf_pars_fragment:Q2,logdepthbuf_pars_vertex:tP,logdepthbuf_vertex:eP,map_fragment:nP,map_pars_fragment:iP,map_particle_fragment:sP,map_particle_pars_fragment:oP,metalnessmap_fragment:rP,metalnessmap_pars_fragment:aP,morphinstance_vertex:lP,morphcolor_vertex:cP,morphnormal_vertex:hP,morphtarget_pars_vertex:uP,morphtarget_vertex:dP,normal_fragment_begin:fP,normal_fragment_maps:pP,normal_pars_fragment:mP,normal_pars_vertex:gP,normal_vertex:_P,normalmap_pars_fragment:vP,clearcoat_normal_fragment_begin:xP,clearcoat_normal_fragment_maps:bP,clearcoat_pars_fragment:yP,iridescence_pars_fragment:MP,opaque_fragment:SP,packing:wP,premultiplied_alpha_fragment:EP,project_vertex:TP,dithering_fragment:AP,dithering_pars_fragment:RP,roughnessmap_fragment:CP,roughnessmap_pars_fragment:PP,shadowmap_pars_fragment:LP,shadowmap_pars_vertex:DP,shadowmap_vertex:IP,shadowmask_pars_fragment:NP,skinbase_vertex:UP,skinning_pars_vertex:kP,skinning_vertex:FP,skinnormal_vertex:OP,specularmap_fragment:BP,specularmap_pars_fragment:zP,tonemapping_fragment:HP,tonemapping_pars_fragment:VP,transmission_fragment:GP,transmission_pars_fragment:WP,uv_pars_fragment:$P,uv_pars_vertex:qP,uv_vertex:XP,worldpos_vertex:jP,background_vert:YP,background_frag:KP,backgroundCube_vert:ZP,backgroundCube_frag:JP,cube_vert:QP,cube_frag:tL,depth_vert:eL,depth_frag:nL,distanceRGBA_vert:iL,distanceRGBA_frag:sL,equirect_vert:oL,equirect_frag:rL,linedashed_vert:aL,linedashed_frag:lL,meshbasic_vert:cL,meshbasic_frag:hL,meshlambert_vert:uL,meshlambert_frag:dL,meshmatcap_vert:fL,meshmatcap_frag:pL,meshnormal_vert:mL,meshnormal_frag:gL,meshphong_vert:_L,meshphong_frag:vL,meshphysical_vert:xL,meshphysical_frag:bL,meshtoon_vert:yL,meshtoon_frag:ML,points_vert:SL,points_frag:wL,shadow_vert:EL,shadow_frag:TL,sprite_vert:AL,sprite_frag:RL},Tt={common:{diffuse:{value:new pe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ee}},envmap:{envMap:{value:null},envMapRotation:{value:new ee},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ee}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ee}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ee},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ee},normalScale:{value:new xe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ee},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ee}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ee}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ee}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new pe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new pe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0},uvTransform:{value:new ee}},sprite:{diffuse:{value:new pe(16777215)},opacity:{value:1},center:{value:new xe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}}},vi={basic:{uniforms:wn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.fog]),vertexShader:se.meshbasic_vert,fragmentShader:se.meshbasic_frag},lambert:{uniforms:wn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,Tt.lights,{emissive:{value:new pe(0)}}]),vertexShader:se.meshlambert_vert,fragmentShader:se.meshlambert_frag},phong:{uniforms:wn([Tt.common,Tt.specularmap,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,Tt.lights,{emissive:{value:new pe(0)},specular:{value:new pe(1118481)},shininess:{value:30}}]),vertexShader:se.meshphong_vert,fragmentShader:se.meshphong_frag},standard:{uniforms:wn([Tt.common,Tt.envmap,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.roughnessmap,Tt.metalnessmap,Tt.fog,Tt.lights,{emissive:{value:new pe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:se.meshphysical_vert,fragmentShader:se.meshphysical_frag},toon:{uniforms:wn([Tt.common,Tt.aomap,Tt.lightmap,Tt.emissivemap,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.gradientmap,Tt.fog,Tt.lights,{emissive:{value:new pe(0)}}]),vertexShader:se.meshtoon_vert,fragmentShader:se.meshtoon_frag},matcap:{uniforms:wn([Tt.common,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,Tt.fog,{matcap:{value:null}}]),vertexShader:se.meshmatcap_vert,fragmentShader:se.meshmatcap_frag},points:{uniforms:wn([Tt.points,Tt.fog]),vertexShader:se.points_vert,fragmentShader:se.points_frag},dashed:{uniforms:wn([Tt.common,Tt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:se.linedashed_vert,fragmentShader:se.linedashed_frag},depth:{uniforms:wn([Tt.common,Tt.displacementmap]),vertexShader:se.depth_vert,fragmentShader:se.depth_frag},normal:{uniforms:wn([Tt.common,Tt.bumpmap,Tt.normalmap,Tt.displacementmap,{opacity:{value:1}}]),vertexShader:se.meshnormal_vert,fragmentShader:se.meshnormal_frag},sprite:{uniforms:wn([Tt.sprite,Tt.fog]),vertexShader:se.sprite_vert,fragmentShader:se.sprite_frag},background:{uniforms:{uvTransform:{value:new ee},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:se.background_vert,fragmentShader:se.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ee}},vertexShader:se.backgroundCube_vert,fragmentShader:se.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:se.cube_vert,fragmentShader:se.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:se.equirect_vert,fragmentShader:se.equirect_frag},distanceRGBA:{uniforms:wn([Tt.common,Tt.displacementmap,{referencePosition:{value:new et},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:se.distanceRGBA_vert,fragmentShader:se.distanceRGBA_frag},shadow:{uniforms:wn([Tt.lights,Tt.fog,{color:{value:new pe(0)},opacity:{value:1}}]),vertexShader:se.shadow_vert,fragmentShader:se.shadow_frag}};vi.physical={uniforms:wn([vi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ee},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ee},clearcoatNormalScale:{value:new xe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ee},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ee},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ee},sheen:{value:0},sheenColor:{value:new pe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ee},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ee},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ee},transmissionSamplerSize:{value:new xe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ee},attenuationDistance:{value:0},attenuationColor:{value:new pe(0)},specularColor:{value:new pe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ee},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ee},anisotropyVector:{value:new xe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ee}}]),vertexShader:se.meshphysical_vert,fragmentShader:se.meshphysical_frag};const ha={r:0,b:0,g:0},As=new wi,CL=new Ve;function PL(i,t,e,n,s,o,r){const a=new pe(0);let l=o===!0?0:1,c,h,u=null,d=0,p=null;function _(M){let S=M.isScene===!0?M.background:null;return S&&S.isTexture&&(S=(M.backgroundBlurriness>0?e:t).get(S)),S}function g(M){let S=!1;const x=_(M);x===null?f(a,l):x&&x.isColor&&(f(x,1),S=!0);const k=i.xr.getEnvironmentBlendMode();k==="additive"?n.buffers.color.setClear(0,0,0,1,r):k==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(M,S){const x=_(S);x&&(x.isCubeTexture||x.mapping===tl)?(h===void 0&&(h=new fn(new js(1,1,1),new ps({name:"BackgroundCubeMaterial",uniforms:Wo(vi.backgroundCube.uniforms),vertexShader:vi.backgroundCube.vertexShader,fragmentShader:vi.backgroundCube.fragmentShader,side:Ln,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(k,P,A){this.matrixWorld.copyPosition(A.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),As.copy(S.backgroundRotation),As.x*=-1,As.y*=-1,As.z*=-1,x.isCubeTexture&&x.isRenderTargetTexture===!1&&(As.y*=-1,As.z*=-1),h.material.uniforms.envMap.value=x,h.material.uniforms.flipEnvMap.value=x.isCubeTexture&&x.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(CL.makeRotationFromEuler(As)),h.material.toneMapped=ve.getTransfer(x.colorSpace)!==Ce,(u!==x||d!==x.version||p!==i.toneMapping)&&(h.material.needsUpdate=!0,u=x,d=x.version,p=i.toneMapping),h.layers.enableAll(),M.unshift(h,h.geometry,h.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new fn(new Pr(2,2),new ps({name:"BackgroundMaterial",uniforms:Wo(vi.background.uniforms),vertexShader:vi.background.vertexShader,fragmentShader:vi.background.fragmentShader,side:fs,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=ve.getTransfer(x.colorSpace)!==Ce,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(u!==x||d!==x.version||p!==i.toneMapping)&&(c.material.needsUpdate=!0,u=x,d=x.version,p=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function f(M,S){M.getRGB(ha,Vm(i)),n.buffers.color.setClear(ha.r,ha.g,ha.b,S,r)}return{getClearColor:function(){return a},setClearColor:function(M,S=1){a.set(M),l=S,f(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(M){l=M,f(a,l)},render:g,addToRenderList:m}}function LL(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null);let o=s,r=!1;function a(b,R,H,O,q){let $=!1;const X=u(O,H,R);o!==X&&(o=X,c(o.object)),$=p(b,O,H,q),$&&_(b,O,H,q),q!==null&&t.update(q,i.ELEMENT_ARRAY_BUFFER),($||r)&&(r=!1,x(b,R,H,O),q!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(q).buffer))}function l(){return i.createVertexArray()}function c(b){return i.bindVertexArray(b)}function h(b){return i.deleteVertexArray(b)}function u(b,R,H){const O=H.wireframe===!0;let q=n[b.id];q===void 0&&(q={},n[b.id]=q);let $=q[R.id];$===void 0&&($={},q[R.id]=$);let X=$[O];return X===void 0&&(X=d(l()),$[O]=X),X}function d(b){const R=[],H=[],O=[];for(let q=0;q<e;q++)R[q]=0,H[q]=0,O[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:R,enabledAttributes:H,attributeDivisors:O,object:b,attributes:{},index:null}}function p(b,R,H,O){const q=o.attributes,$=R.attributes;let X=0;const j=H.getAttributes();for(const Q in j)if(j[Q].location>=0){const lt=q[Q];let gt=$[Q];if(gt===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(gt=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(gt=b.instanceColor)),lt===void 0||lt.attribute!==gt||gt&&lt.data!==gt.data)return!0;X++}return o.attributesNum!==X||o.index!==O}function _(b,R,H,O){const q={},$=R.attributes;let X=0;const j=H.getAttributes();for(const Q in j)if(j[Q].location>=0){let lt=$[Q];lt===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(lt=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(lt=b.instanceColor));const gt={};gt.attribute=lt,lt&&lt.data&&(gt.data=lt.data),q[Q]=gt,X++}o.attributes=q,o.attributesNum=X,o.index=O}function g(){const b=o.newAttributes;for(let R=0,H=b.length;R<H;R++)b[R]=0}function m(b){f(b,0)}function f(b,R){const H=o.newAttributes,O=o.enabledAttributes,q=o.attributeDivisors;H[b]=1,O[b]===0&&(i.enableVertexAttribArray(b),O[b]=1),q[b]!==R&&(i.vertexAttribDivisor(b,R),q[b]=R)}function M(){const b=o.newAttributes,R=o.enabledAttributes;for(let H=0,O=R.length;H<O;H++)R[H]!==b[H]&&(i.disableVertexAttribArray(H),R[H]=0)}function S(b,R,H,O,q,$,X){X===!0?i.vertexAttribIPointer(b,R,H,q,$):i.vertexAttribPointer(b,R,H,O,q,$)}function x(b,R,H,O){g();const q=O.attributes,$=H.getAttributes(),X=R.defaultAttributeValues;for(const j in $){const Q=$[j];if(Q.location>=0){let at=q[j];if(at===void 0&&(j==="instanceMatrix"&&b.instanceMatrix&&(at=b.instanceMatrix),j==="instanceColor"&&b.instanceColor&&(at=b.instanceColor)),at!==void 0){const lt=at.normalized,gt=at.itemSize,xt=t.get(at);if(xt===void 0)continue;const mt=xt.buffer,ot=xt.type,ut=xt.bytesPerElement,_t=ot===i.INT||ot===i.UNSIGNED_INT||at.gpuType===Gh;if(at.isInterleavedBufferAttribute){const ht=at.data,Nt=ht.stride,zt=at.offset;if(ht.isInstancedInterleavedBuffer){for(let Ut=0;Ut<Q.locationSize;Ut++)f(Q.location+Ut,ht.meshPerAttribute);b.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let Ut=0;Ut<Q.locationSize;Ut++)m(Q.location+Ut);i.bindBuffer(i.ARRAY_BUFFER,mt);for(let Ut=0;Ut<Q.locationSize;Ut++)S(Q.location+Ut,gt/Q.locationSize,ot,lt,Nt*ut,(zt+gt/Q.locationSize*Ut)*ut,_t)}else{if(at.isInstancedBufferAttribute){for(let ht=0;ht<Q.locationSize;ht++)f(Q.location+ht,at.meshPerAttribute);b.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=at.meshPerAttribute*at.count)}else for(let ht=0;ht<Q.locationSize;ht++)m(Q.location+ht);i.bindBuffer(i.ARRAY_BUFFER,mt);for(let ht=0;ht<Q.locationSize;ht++)S(Q.location+ht,gt/Q.locationSize,ot,lt,gt*ut,gt/Q.locationSize*ht*ut,_t)}}else if(X!==void 0){const lt=X[j];if(lt!==void 0)switch(lt.length){case 2:i.vertexAttrib2fv(Q.location,lt);break;case 3:i.vertexAttrib3fv(Q.location,lt);break;case 4:i.vertexAttrib4fv(Q.location,lt);break;default:i.vertexAttrib1fv(Q.location,lt)}}}}M()}function k(){I();for(const b in n){const R=n[b];for(const H in R){const O=R[H];for(const q in O)h(O[q].object),delete O[q];delete R[H]}delete n[b]}}function P(b){if(n[b.id]===void 0)return;const R=n[b.id];for(const H in R){const O=R[H];for(const q in O)h(O[q].object),delete O[q];delete R[H]}delete n[b.id]}function A(b){for(const R in n){const H=n[R];if(H[b.id]===void 0)continue;const O=H[b.id];for(const q in O)h(O[q].object),delete O[q];delete H[b.id]}}function I(){E(),r=!0,o!==s&&(o=s,c(o.object))}function E(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:E,dispose:k,releaseStatesOfGeometry:P,releaseStatesOfProgram:A,initAttributes:g,enableAttribute:m,disableUnusedAttributes:M}}function DL(i,t,e){let n;function s(c){n=c}function o(c,h){i.drawArrays(n,c,h),e.update(h,n,1)}function r(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),e.update(h,n,u))}function a(c,h,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let p=0;for(let _=0;_<u;_++)p+=h[_];e.update(p,n,1)}function l(c,h,u,d){if(u===0)return;const p=t.get("WEBGL_multi_draw");if(p===null)for(let _=0;_<c.length;_++)r(c[_],h[_],d[_]);else{p.multiDrawArraysInstancedWEBGL(n,c,0,h,0,d,0,u);let _=0;for(let g=0;g<u;g++)_+=h[g]*d[g];e.update(_,n,1)}}this.setMode=s,this.render=o,this.renderInstances=r,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function IL(i,t,e,n){let s;function o(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const A=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(A.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function r(A){return!(A!==li&&n.convert(A)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(A){const I=A===Er&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(A!==Wi&&n.convert(A)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&A!==Fi&&!I)}function l(A){if(A==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";A="mediump"}return A==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=e.logarithmicDepthBuffer===!0,d=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),f=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),k=_>0,P=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:o,getMaxPrecision:l,textureFormatReadable:r,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reverseDepthBuffer:d,maxTextures:p,maxVertexTextures:_,maxTextureSize:g,maxCubemapSize:m,maxAttributes:f,maxVertexUniforms:M,maxVaryings:S,maxFragmentUniforms:x,vertexTextures:k,maxSamples:P}}function NL(i){const t=this;let e=null,n=0,s=!1,o=!1;const r=new ss,a=new ee,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){const p=u.length!==0||d||n!==0||s;return s=d,n=u.length,p},this.beginShadows=function(){o=!0,h(null)},this.endShadows=function(){o=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,p){const _=u.clippingPlanes,g=u.clipIntersection,m=u.clipShadows,f=i.get(u);if(!s||_===null||_.length===0||o&&!m)o?h(null):c();else{const M=o?0:n,S=M*4;let x=f.clippingState||null;l.value=x,x=h(_,d,S,p);for(let k=0;k!==S;++k)x[k]=e[k];f.clippingState=x,this.numIntersection=g?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,p,_){const g=u!==null?u.length:0;let m=null;if(g!==0){if(m=l.value,_!==!0||m===null){const f=p+g*4,M=d.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<f)&&(m=new Float32Array(f));for(let S=0,x=p;S!==g;++S,x+=4)r.copy(u[S]).applyMatrix4(M,a),r.normal.toArray(m,x),m[x+3]=r.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=g,t.numIntersection=0,m}}function UL(i){let t=new WeakMap;function e(r,a){return a===kc?r.mapping=zo:a===Fc&&(r.mapping=Ho),r}function n(r){if(r&&r.isTexture){const a=r.mapping;if(a===kc||a===Fc)if(t.has(r)){const l=t.get(r).texture;return e(l,r.mapping)}else{const l=r.image;if(l&&l.height>0){const c=new qC(l.height);return c.fromEquirectangularTexture(i,r),t.set(r,c),r.addEventListener("dispose",s),e(c.texture,r.mapping)}else return null}}return r}function s(r){const a=r.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function o(){t=new WeakMap}return{get:n,dispose:o}}class qm extends Gm{constructor(t=-1,e=1,n=1,s=-1,o=.1,r=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=o,this.far=r,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,o,r){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let o=n-t,r=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;o+=c*this.view.offsetX,r=o+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(o,r,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Co=4,xf=[.125,.215,.35,.446,.526,.582],ks=20,Jl=new qm,bf=new pe;let Ql=null,tc=0,ec=0,nc=!1;const Ds=(1+Math.sqrt(5))/2,wo=1/Ds,yf=[new et(-Ds,wo,0),new et(Ds,wo,0),new et(-wo,0,Ds),new et(wo,0,Ds),new et(0,Ds,-wo),new et(0,Ds,wo),new et(-1,1,-1),new et(1,1,-1),new et(-1,1,1),new et(1,1,1)];class Mf{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100){Ql=this._renderer.getRenderTarget(),tc=this._renderer.getActiveCubeFace(),ec=this._renderer.getActiveMipmapLevel(),nc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const o=this._allocateTargets();return o.depthBuffer=!0,this._sceneToCubeUV(t,n,s,o),e>0&&this._blur(o,0,0,e),this._applyPMREM(o),this._cleanup(o),o}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ef(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=wf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Ql,tc,ec),this._renderer.xr.enabled=nc,t.scissorTest=!1,ua(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===zo||t.mapping===Ho?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Ql=this._renderer.getRenderTarget(),tc=this._renderer.getActiveCubeFace(),ec=this._renderer.getActiveMipmapLevel(),nc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:xi,minFilter:xi,generateMipmaps:!1,type:Er,format:li,colorSpace:Ko,depthBuffer:!1},s=Sf(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Sf(t,e,n);const{_lodMax:o}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=kL(o)),this._blurMaterial=FL(o,t,e)}return s}_compileMaterial(t){const e=new fn(this._lodPlanes[0],t);this._renderer.compile(e,Jl)}_sceneToCubeUV(t,e,n,s){const a=new jn(90,1,e,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,u=h.autoClear,d=h.toneMapping;h.getClearColor(bf),h.toneMapping=ls,h.autoClear=!1;const p=new Zh({name:"PMREM.Background",side:Ln,depthWrite:!1,depthTest:!1}),_=new fn(new js,p);let g=!1;const m=t.background;m?m.isColor&&(p.color.copy(m),t.background=null,g=!0):(p.color.copy(bf),g=!0);for(let f=0;f<6;f++){const M=f%3;M===0?(a.up.set(0,l[f],0),a.lookAt(c[f],0,0)):M===1?(a.up.set(0,0,l[f]),a.lookAt(0,c[f],0)):(a.up.set(0,l[f],0),a.lookAt(0,0,c[f]));const S=this._cubeSize;ua(s,M*S,f>2?S:0,S,S),h.setRenderTarget(s),g&&h.render(_,a),h.render(t,a)}_.geometry.dispose(),_.material.dispose(),h.toneMapping=d,h.autoClear=u,t.background=m}_textureToCubeUV(t,e){const n=this._renderer,s=t.mapping===zo||t.mapping===Ho;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ef()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=wf());const o=s?this._cubemapMaterial:this._equirectMaterial,r=new fn(this._lodPlanes[0],o),a=o.uniforms;a.envMap.value=t;const l=this._cubeSize;ua(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(r,Jl)}_applyPMREM(t){const e=this._renderer,n=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let o=1;o<s;o++){const r=Math.sqrt(this._sigmas[o]*this._sigmas[o]-this._sigmas[o-1]*this._sigmas[o-1]),a=yf[(s-o-1)%yf.length];this._blur(t,o-1,o,r,a)}e.autoClear=n}_blur(t,e,n,s,o){const r=this._pingPongRenderTarget;this._halfBlur(t,r,e,n,s,"latitudinal",o),this._halfBlur(r,t,n,n,s,"longitudinal",o)}_halfBlur(t,e,n,s,o,r,a){const l=this._renderer,c=this._blurMaterial;r!=="latitudinal"&&r!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const h=3,u=new fn(this._lodPlanes[s],c),d=c.uniforms,p=this._sizeLods[n]-1,_=isFinite(o)?Math.PI/(2*p):2*Math.PI/(2*ks-1),g=o/_,m=isFinite(o)?1+Math.floor(h*g):ks;m>ks&&console.warn(`sigmaRadians, ${o}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${ks}`);const f=[];let M=0;for(let A=0;A<ks;++A){const I=A/g,E=Math.exp(-I*I/2);f.push(E),A===0?M+=E:A<m&&(M+=2*E)}for(let A=0;A<f.length;A++)f[A]=f[A]/M;d.envMap.value=t.texture,d.samples.value=m,d.weights.value=f,d.latitudinal.value=r==="latitudinal",a&&(d.poleAxis.value=a);const{_lodMax:S}=this;d.dTheta.value=_,d.mipInt.value=S-n;const x=this._sizeLods[s],k=3*x*(s>S-Co?s-S+Co:0),P=4*(this._cubeSize-x);ua(e,k,P,3*x,2*x),l.setRenderTarget(e),l.render(u,Jl)}}function kL(i){const t=[],e=[],n=[];let s=i;const o=i-Co+1+xf.length;for(let r=0;r<o;r++){const a=Math.pow(2,s);e.push(a);let l=1/a;r>i-Co?l=xf[r-i+Co-1]:r===0&&(l=0),n.push(l);const c=1/(a-2),h=-c,u=1+c,d=[h,h,u,h,u,u,h,h,u,u,h,u],p=6,_=6,g=3,m=2,f=1,M=new Float32Array(g*_*p),S=new Float32Array(m*_*p),x=new Float32Array(f*_*p);for(let P=0;P<p;P++){const A=P%3*2/3-1,I=P>2?0:-1,E=[A,I,0,A+2/3,I,0,A+2/3,I+1,0,A,I,0,A+2/3,I+1,0,A,I+1,0];M.set(E,g*_*P),S.set(d,m*_*P);const b=[P,P,P,P,P,P];x.set(b,f*_*P)}const k=new ms;k.setAttribute("position",new Mi(M,g)),k.setAttribute("uv",new Mi(S,m)),k.setAttribute("faceIndex",new Mi(x,f)),t.push(k),s>Co&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function Sf(i,t,e){const n=new Xs(i,t,e);return n.texture.mapping=tl,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function ua(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function FL(i,t,e){const n=new Float32Array(ks),s=new et(0,1,0);return new ps({name:"SphericalGaussianBlur",defines:{n:ks,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Qh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:as,depthTest:!1,depthWrite:!1})}function wf(){return new ps({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Qh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:as,depthTest:!1,depthWrite:!1})}function Ef(){return new ps({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Qh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:as,depthTest:!1,depthWrite:!1})}function Qh(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function OL(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===kc||l===Fc,h=l===zo||l===Ho;if(c||h){let u=t.get(a);const d=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return e===null&&(e=new Mf(i)),u=c?e.fromEquirectangular(a,u):e.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),u.texture;if(u!==void 0)return u.texture;{const p=a.image;return c&&p&&p.height>0||h&&p&&s(p)?(e===null&&(e=new Mf(i)),u=c?e.fromEquirectangular(a):e.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),a.addEventListener("dispose",o),u.texture):null}}}return a}function s(a){let l=0;const c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function o(a){const l=a.target;l.removeEventListener("dispose",o);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function r(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:r}}function BL(i){const t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&_r("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function zL(i,t,e,n){const s={},o=new WeakMap;function r(u){const d=u.target;d.index!==null&&t.remove(d.index);for(const _ in d.attributes)t.remove(d.attributes[_]);for(const _ in d.morphAttributes){const g=d.morphAttributes[_];for(let m=0,f=g.length;m<f;m++)t.remove(g[m])}d.removeEventListener("dispose",r),delete s[d.id];const p=o.get(d);p&&(t.remove(p),o.delete(d)),n.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,e.memory.geometries--}function a(u,d){return s[d.id]===!0||(d.addEventListener("dispose",r),s[d.id]=!0,e.memory.geometries++),d}function l(u){const d=u.attributes;for(const _ in d)t.update(d[_],i.ARRAY_BUFFER);const p=u.morphAttributes;for(const _ in p){const g=p[_];for(let m=0,f=g.length;m<f;m++)t.update(g[m],i.ARRAY_BUFFER)}}function c(u){const d=[],p=u.index,_=u.attributes.position;let g=0;if(p!==null){const M=p.array;g=p.version;for(let S=0,x=M.length;S<x;S+=3){const k=M[S+0],P=M[S+1],A=M[S+2];d.push(k,P,P,A,A,k)}}else if(_!==void 0){const M=_.array;g=_.version;for(let S=0,x=M.length/3-1;S<x;S+=3){const k=S+0,P=S+1,A=S+2;d.push(k,P,P,A,A,k)}}else return;const m=new(Um(d)?Hm:zm)(d,1);m.version=g;const f=o.get(u);f&&t.remove(f),o.set(u,m)}function h(u){const d=o.get(u);if(d){const p=u.index;p!==null&&d.version<p.version&&c(u)}else c(u);return o.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function HL(i,t,e){let n;function s(d){n=d}let o,r;function a(d){o=d.type,r=d.bytesPerElement}function l(d,p){i.drawElements(n,p,o,d*r),e.update(p,n,1)}function c(d,p,_){_!==0&&(i.drawElementsInstanced(n,p,o,d*r,_),e.update(p,n,_))}function h(d,p,_){if(_===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,p,0,o,d,0,_);let m=0;for(let f=0;f<_;f++)m+=p[f];e.update(m,n,1)}function u(d,p,_,g){if(_===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let f=0;f<d.length;f++)c(d[f]/r,p[f],g[f]);else{m.multiDrawElementsInstancedWEBGL(n,p,0,o,d,0,g,0,_);let f=0;for(let M=0;M<_;M++)f+=p[M]*g[M];e.update(f,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function VL(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(o,r,a){switch(e.calls++,r){case i.TRIANGLES:e.triangles+=a*(o/3);break;case i.LINES:e.lines+=a*(o/2);break;case i.LINE_STRIP:e.lines+=a*(o-1);break;case i.LINE_LOOP:e.lines+=a*o;break;case i.POINTS:e.points+=a*o;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",r);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function GL(i,t,e){const n=new WeakMap,s=new $e;function o(r,a,l){const c=r.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0;let d=n.get(a);if(d===void 0||d.count!==u){let b=function(){I.dispose(),n.delete(a),a.removeEventListener("dispose",b)};var p=b;d!==void 0&&d.texture.dispose();const _=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,f=a.morphAttributes.position||[],M=a.morphAttributes.normal||[],S=a.morphAttributes.color||[];let x=0;_===!0&&(x=1),g===!0&&(x=2),m===!0&&(x=3);let k=a.attributes.position.count*x,P=1;k>t.maxTextureSize&&(P=Math.ceil(k/t.maxTextureSize),k=t.maxTextureSize);const A=new Float32Array(k*P*4*u),I=new Fm(A,k,P,u);I.type=Fi,I.needsUpdate=!0;const E=x*4;for(let R=0;R<u;R++){const H=f[R],O=M[R],q=S[R],$=k*P*4*R;for(let X=0;X<H.count;X++){const j=X*E;_===!0&&(s.fromBufferAttribute(H,X),A[$+j+0]=s.x,A[$+j+1]=s.y,A[$+j+2]=s.z,A[$+j+3]=0),g===!0&&(s.fromBufferAttribute(O,X),A[$+j+4]=s.x,A[$+j+5]=s.y,A[$+j+6]=s.z,A[$+j+7]=0),m===!0&&(s.fromBufferAttribute(q,X),A[$+j+8]=s.x,A[$+j+9]=s.y,A[$+j+10]=s.z,A[$+j+11]=q.itemSize===4?s.w:1)}}d={count:u,texture:I,size:new xe(k,P)},n.set(a,d),a.addEventListener("dispose",b)}if(r.isInstancedMesh===!0&&r.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",r.morphTexture,e);else{let _=0;for(let m=0;m<c.length;m++)_+=c[m];const g=a.morphTargetsRelative?1:1-_;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:o}}function WL(i,t,e,n){let s=new WeakMap;function o(l){const c=n.render.frame,h=l.geometry,u=t.get(l,h);if(s.get(u)!==c&&(t.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return u}function r(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:o,dispose:r}}class Xm extends Tn{constructor(t,e,n,s,o,r,a,l,c,h=Do){if(h!==Do&&h!==Go)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===Do&&(n=qs),n===void 0&&h===Go&&(n=Vo),super(null,s,o,r,a,l,h,n,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:ci,this.minFilter=l!==void 0?l:ci,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const jm=new Tn,Tf=new Xm(1,1),Ym=new Fm,Km=new PC,Zm=new Wm,Af=[],Rf=[],Cf=new Float32Array(16),Pf=new Float32Array(9),Lf=new Float32Array(4);function Jo(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let o=Af[s];if(o===void 0&&(o=new Float32Array(s),Af[s]=o),t!==0){n.toArray(o,0);for(let r=1,a=0;r!==t;++r)a+=e,i[r].toArray(o,a)}return o}function en(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function nn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function nl(i,t){let e=Rf[t];e===void 0&&(e=new Int32Array(t),Rf[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function $L(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function qL(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(en(e,t))return;i.uniform2fv(this.addr,t),nn(e,t)}}function XL(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(en(e,t))return;i.uniform3fv(this.addr,t),nn(e,t)}}function jL(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(en(e,t))return;i.uniform4fv(this.addr,t),nn(e,t)}}function YL(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(en(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),nn(e,t)}else{if(en(e,n))return;Lf.set(n),i.uniformMatrix2fv(this.addr,!1,Lf),nn(e,n)}}function KL(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(en(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),nn(e,t)}else{if(en(e,n))return;Pf.set(n),i.uniformMatrix3fv(this.addr,!1,Pf),nn(e,n)}}function ZL(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(en(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),nn(e,t)}else{if(en(e,n))return;Cf.set(n),i.uniformMatrix4fv(this.addr,!1,Cf),nn(e,n)}}function JL(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function QL(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(en(e,t))return;i.uniform2iv(this.addr,t),nn(e,t)}}function tD(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(en(e,t))return;i.uniform3iv(this.addr,t),nn(e,t)}}function eD(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(en(e,t))return;i.uniform4iv(this.addr,t),nn(e,t)}}function nD(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function iD(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(en(e,t))return;i.uniform2uiv(this.addr,t),nn(e,t)}}function sD(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(en(e,t))return;i.uniform3uiv(this.addr,t),nn(e,t)}}function oD(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(en(e,t))return;i.uniform4uiv(this.addr,t),nn(e,t)}}function rD(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let o;this.type===i.SAMPLER_2D_SHADOW?(Tf.compareFunction=Nm,o=Tf):o=jm,e.setTexture2D(t||o,s)}function aD(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Km,s)}function lD(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||Zm,s)}function cD(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Ym,s)}function hD(i){switch(i){case 5126:return $L;case 35664:return qL;case 35665:return XL;case 35666:return jL;case 35674:return YL;case 35675:return KL;case 35676:return ZL;case 5124:case 35670:return JL;case 35667:case 35671:return QL;case 35668:case 35672:return tD;case 35669:case 35673:return eD;case 5125:return nD;case 36294:return iD;case 36295:return sD;case 36296:return oD;case 35678:case 36198:case 36298:case 36306:case 35682:return rD;case 35679:case 36299:case 36307:return aD;case 35680:case 36300:case 36308:case 36293:return lD;case 36289:case 36303:case 36311:case 36292:return cD}}function uD(i,t){i.uniform1fv(this.addr,t)}function dD(i,t){const e=Jo(t,this.size,2);i.uniform2fv(this.addr,e)}function fD(i,t){const e=Jo(t,this.size,3);i.uniform3fv(this.addr,e)}function pD(i,t){const e=Jo(t,this.size,4);i.uniform4fv(this.addr,e)}function mD(i,t){const e=Jo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function gD(i,t){const e=Jo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function _D(i,t){const e=Jo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function vD(i,t){i.uniform1iv(this.addr,t)}function xD(i,t){i.uniform2iv(this.addr,t)}function bD(i,t){i.uniform3iv(this.addr,t)}function yD(i,t){i.uniform4iv(this.addr,t)}function MD(i,t){i.uniform1uiv(this.addr,t)}function SD(i,t){i.uniform2uiv(this.addr,t)}function wD(i,t){i.uniform3uiv(this.addr,t)}function ED(i,t){i.uniform4uiv(this.addr,t)}function TD(i,t,e){const n=this.cache,s=t.length,o=nl(e,s);en(n,o)||(i.uniform1iv(this.addr,o),nn(n,o));for(let r=0;r!==s;++r)e.setTexture2D(t[r]||jm,o[r])}function AD(i,t,e){const n=this.cache,s=t.length,o=nl(e,s);en(n,o)||(i.uniform1iv(this.addr,o),nn(n,o));for(let r=0;r!==s;++r)e.setTexture3D(t[r]||Km,o[r])}function RD(i,t,e){const n=this.cache,s=t.length,o=nl(e,s);en(n,o)||(i.uniform1iv(this.addr,o),nn(n,o));for(let r=0;r!==s;++r)e.setTextureCube(t[r]||Zm,o[r])}function CD(i,t,e){const n=this.cache,s=t.length,o=nl(e,s);en(n,o)||(i.uniform1iv(this.addr,o),nn(n,o));for(let r=0;r!==s;++r)e.setTexture2DArray(t[r]||Ym,o[r])}function PD(i){switch(i){case 5126:return uD;case 35664:return dD;case 35665:return fD;case 35666:return pD;case 35674:return mD;case 35675:return gD;case 35676:return _D;case 5124:case 35670:return vD;case 35667:case 35671:return xD;case 35668:case 35672:return bD;case 35669:case 35673:return yD;case 5125:return MD;case 36294:return SD;case 36295:return wD;case 36296:return ED;case 35678:case 36198:case 36298:case 36306:case 35682:return TD;case 35679:case 36299:case 36307:return AD;case 35680:case 36300:case 36308:case 36293:return RD;case 36289:case 36303:case 36311:case 36292:return CD}}class LD{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=hD(e.type)}}class DD{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=PD(e.type)}}class ID{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let o=0,r=s.length;o!==r;++o){const a=s[o];a.setValue(t,e[a.id],n)}}}const ic=/(\w+)(\])?(\[|\.)?/g;function Df(i,t){i.seq.push(t),i.map[t.id]=t}function ND(i,t,e){const n=i.name,s=n.length;for(ic.lastIndex=0;;){const o=ic.exec(n),r=ic.lastIndex;let a=o[1];const l=o[2]==="]",c=o[3];if(l&&(a=a|0),c===void 0||c==="["&&r+2===s){Df(e,c===void 0?new LD(a,i,t):new DD(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new ID(a),Df(e,u)),e=u}}}class Ea{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const o=t.getActiveUniform(e,s),r=t.getUniformLocation(e,o.name);ND(o,r,this)}}setValue(t,e,n,s){const o=this.map[e];o!==void 0&&o.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let o=0,r=e.length;o!==r;++o){const a=e[o],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,o=t.length;s!==o;++s){const r=t[s];r.id in e&&n.push(r)}return n}}function If(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const UD=37297;let kD=0;function FD(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),o=Math.min(t+6,e.length);for(let r=s;r<o;r++){const a=r+1;n.push(`${a===t?">":" "} ${a}: ${e[r]}`)}return n.join(`
`)}const Nf=new ee;function OD(i){ve._getMatrix(Nf,ve.workingColorSpace,i);const t=`mat3( ${Nf.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(i)){case el:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Uf(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),s=i.getShaderInfoLog(t).trim();if(n&&s==="")return"";const o=/ERROR: 0:(\d+)/.exec(s);if(o){const r=parseInt(o[1]);return e.toUpperCase()+`

`+s+`

`+FD(i.getShaderSource(t),r)}else return s}function BD(i,t){const e=OD(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function zD(i,t){let e;switch(t){case iC:e="Linear";break;case sC:e="Reinhard";break;case oC:e="Cineon";break;case rC:e="ACESFilmic";break;case lC:e="AgX";break;case cC:e="Neutral";break;case aC:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const da=new et;function HD(){ve.getLuminanceCoefficients(da);const i=da.x.toFixed(4),t=da.y.toFixed(4),e=da.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function VD(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(vr).join(`
`)}function GD(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function WD(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const o=i.getActiveAttrib(t,s),r=o.name;let a=1;o.type===i.FLOAT_MAT2&&(a=2),o.type===i.FLOAT_MAT3&&(a=3),o.type===i.FLOAT_MAT4&&(a=4),e[r]={type:o.type,location:i.getAttribLocation(t,r),locationSize:a}}return e}function vr(i){return i!==""}function kf(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function Ff(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const $D=/^[ \t]*#include +<([\w\d./]+)>/gm;function dh(i){return i.replace($D,XD)}const qD=new Map;function XD(i,t){let e=se[t];if(e===void 0){const n=qD.get(t);if(n!==void 0)e=se[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return dh(e)}const jD=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Of(i){return i.replace(jD,YD)}function YD(i,t,e,n){let s="";for(let o=parseInt(t);o<parseInt(e);o++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+o+" ]").replace(/UNROLLED_LOOP_INDEX/g,o);return s}function Bf(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function KD(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===xm?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===bm?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Ni&&(t="SHADOWMAP_TYPE_VSM"),t}function ZD(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case zo:case Ho:t="ENVMAP_TYPE_CUBE";break;case tl:t="ENVMAP_TYPE_CUBE_UV";break}return t}function JD(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Ho:t="ENVMAP_MODE_REFRACTION";break}return t}function QD(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case ym:t="ENVMAP_BLENDING_MULTIPLY";break;case eC:t="ENVMAP_BLENDING_MIX";break;case nC:t="ENVMAP_BLENDING_ADD";break}return t}function tI(i){const t=i.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function eI(i,t,e,n){const s=i.getContext(),o=e.defines;let r=e.vertexShader,a=e.fragmentShader;const l=KD(e),c=ZD(e),h=JD(e),u=QD(e),d=tI(e),p=VD(e),_=GD(o),g=s.createProgram();let m,f,M=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(vr).join(`
`),m.length>0&&(m+=`
`),f=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(vr).join(`
`),f.length>0&&(f+=`
`)):(m=[Bf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(vr).join(`
`),f=[Bf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ls?"#define TONE_MAPPING":"",e.toneMapping!==ls?se.tonemapping_pars_fragment:"",e.toneMapping!==ls?zD("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",se.colorspace_pars_fragment,BD("linearToOutputTexel",e.outputColorSpace),HD(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(vr).join(`
`)),r=dh(r),r=kf(r,e),r=Ff(r,e),a=dh(a),a=kf(a,e),a=Ff(a,e),r=Of(r),a=Of(a),e.isRawShaderMaterial!==!0&&(M=`#version 300 es
`,m=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,f=["#define varying in",e.glslVersion===Zd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Zd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);const S=M+m+r,x=M+f+a,k=If(s,s.VERTEX_SHADER,S),P=If(s,s.FRAGMENT_SHADER,x);s.attachShader(g,k),s.attachShader(g,P),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(R){if(i.debug.checkShaderErrors){const H=s.getProgramInfoLog(g).trim(),O=s.getShaderInfoLog(k).trim(),q=s.getShaderInfoLog(P).trim();let $=!0,X=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if($=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,k,P);else{const j=Uf(s,k,"vertex"),Q=Uf(s,P,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+H+`
`+j+`
`+Q)}else H!==""?console.warn("THREE.WebGLProgram: Program Info Log:",H):(O===""||q==="")&&(X=!1);X&&(R.diagnostics={runnable:$,programLog:H,vertexShader:{log:O,prefix:m},fragmentShader:{log:q,prefix:f}})}s.deleteShader(k),s.deleteShader(P),I=new Ea(s,g),E=WD(s,g)}let I;this.getUniforms=function(){return I===void 0&&A(this),I};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let b=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(g,UD)),b},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=kD++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=k,this.fragmentShader=P,this}let nI=0;class iI{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),o=this._getShaderStage(n),r=this._getShaderCacheForMaterial(t);return r.has(s)===!1&&(r.add(s),s.usedTimes++),r.has(o)===!1&&(r.add(o),o.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new sI(t),e.set(t,n)),n}}class sI{constructor(t){this.id=nI++,this.code=t,this.usedTimes=0}}function oI(i,t,e,n,s,o,r){const a=new Kh,l=new iI,c=new Set,h=[],u=s.logarithmicDepthBuffer,d=s.vertexTextures;let p=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function g(E){return c.add(E),E===0?"uv":`uv${E}`}function m(E,b,R,H,O){const q=H.fog,$=O.geometry,X=E.isMeshStandardMaterial?H.environment:null,j=(E.isMeshStandardMaterial?e:t).get(E.envMap||X),Q=j&&j.mapping===tl?j.image.height:null,at=_[E.type];E.precision!==null&&(p=s.getMaxPrecision(E.precision),p!==E.precision&&console.warn("THREE.WebGLProgram.getParameters:",E.precision,"not supported, using",p,"instead."));const lt=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,gt=lt!==void 0?lt.length:0;let xt=0;$.morphAttributes.position!==void 0&&(xt=1),$.morphAttributes.normal!==void 0&&(xt=2),$.morphAttributes.color!==void 0&&(xt=3);let mt,ot,ut,_t;if(at){const Me=vi[at];mt=Me.vertexShader,ot=Me.fragmentShader}else mt=E.vertexShader,ot=E.fragmentShader,l.update(E),ut=l.getVertexShaderID(E),_t=l.getFragmentShaderID(E);const ht=i.getRenderTarget(),Nt=i.state.buffers.depth.getReversed(),zt=O.isInstancedMesh===!0,Ut=O.isBatchedMesh===!0,ce=!!E.map,Jt=!!E.matcap,he=!!j,G=!!E.aoMap,Ke=!!E.lightMap,te=!!E.bumpMap,ie=!!E.normalMap,Wt=!!E.displacementMap,me=!!E.emissiveMap,Dt=!!E.metalnessMap,D=!!E.roughnessMap,w=E.anisotropy>0,tt=E.clearcoat>0,nt=E.dispersion>0,Y=E.iridescence>0,it=E.sheen>0,St=E.transmission>0,bt=w&&!!E.anisotropyMap,At=tt&&!!E.clearcoatMap,Zt=tt&&!!E.clearcoatNormalMap,pt=tt&&!!E.clearcoatRoughnessMap,yt=Y&&!!E.iridescenceMap,Ot=Y&&!!E.iridescenceThicknessMap,Ht=it&&!!E.sheenColorMap,Et=it&&!!E.sheenRoughnessMap,oe=!!E.specularMap,Yt=!!E.specularColorMap,ge=!!E.specularIntensityMap,V=St&&!!E.transmissionMap,Mt=St&&!!E.thicknessMap,st=!!E.gradientMap,ct=!!E.alphaMap,Rt=E.alphaTest>0,Ct=!!E.alphaHash,Qt=!!E.extensions;let Oe=ls;E.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(Oe=i.toneMapping);const sn={shaderID:at,shaderType:E.type,shaderName:E.name,vertexShader:mt,fragmentShader:ot,defines:E.defines,customVertexShaderID:ut,customFragmentShaderID:_t,isRawShaderMaterial:E.isRawShaderMaterial===!0,glslVersion:E.glslVersion,precision:p,batching:Ut,batchingColor:Ut&&O._colorsTexture!==null,instancing:zt,instancingColor:zt&&O.instanceColor!==null,instancingMorph:zt&&O.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:ht===null?i.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:Ko,alphaToCoverage:!!E.alphaToCoverage,map:ce,matcap:Jt,envMap:he,envMapMode:he&&j.mapping,envMapCubeUVHeight:Q,aoMap:G,lightMap:Ke,bumpMap:te,normalMap:ie,displacementMap:d&&Wt,emissiveMap:me,normalMapObjectSpace:ie&&E.normalMapType===fC,normalMapTangentSpace:ie&&E.normalMapType===Im,metalnessMap:Dt,roughnessMap:D,anisotropy:w,anisotropyMap:bt,clearcoat:tt,clearcoatMap:At,clearcoatNormalMap:Zt,clearcoatRoughnessMap:pt,dispersion:nt,iridescence:Y,iridescenceMap:yt,iridescenceThicknessMap:Ot,sheen:it,sheenColorMap:Ht,sheenRoughnessMap:Et,specularMap:oe,specularColorMap:Yt,specularIntensityMap:ge,transmission:St,transmissionMap:V,thicknessMap:Mt,gradientMap:st,opaque:E.transparent===!1&&E.blending===Lo&&E.alphaToCoverage===!1,alphaMap:ct,alphaTest:Rt,alphaHash:Ct,combine:E.combine,mapUv:ce&&g(E.map.channel),aoMapUv:G&&g(E.aoMap.channel),lightMapUv:Ke&&g(E.lightMap.channel),bumpMapUv:te&&g(E.bumpMap.channel),normalMapUv:ie&&g(E.normalMap.channel),displacementMapUv:Wt&&g(E.displacementMap.channel),emissiveMapUv:me&&g(E.emissiveMap.channel),metalnessMapUv:Dt&&g(E.metalnessMap.channel),roughnessMapUv:D&&g(E.roughnessMap.channel),anisotropyMapUv:bt&&g(E.anisotropyMap.channel),clearcoatMapUv:At&&g(E.clearcoatMap.channel),clearcoatNormalMapUv:Zt&&g(E.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:pt&&g(E.clearcoatRoughnessMap.channel),iridescenceMapUv:yt&&g(E.iridescenceMap.channel),iridescenceThicknessMapUv:Ot&&g(E.iridescenceThicknessMap.channel),sheenColorMapUv:Ht&&g(E.sheenColorMap.channel),sheenRoughnessMapUv:Et&&g(E.sheenRoughnessMap.channel),specularMapUv:oe&&g(E.specularMap.channel),specularColorMapUv:Yt&&g(E.specularColorMap.channel),specularIntensityMapUv:ge&&g(E.specularIntensityMap.channel),transmissionMapUv:V&&g(E.transmissionMap.channel),thicknessMapUv:Mt&&g(E.thicknessMap.channel),alphaMapUv:ct&&g(E.alphaMap.channel),vertexTangents:!!$.attributes.tangent&&(ie||w),vertexColors:E.vertexColors,vertexAlphas:E.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,pointsUvs:O.isPoints===!0&&!!$.attributes.uv&&(ce||ct),fog:!!q,useFog:E.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:E.flatShading===!0,sizeAttenuation:E.sizeAttenuation===!0,logarithmicDepthBuffer:u,reverseDepthBuffer:Nt,skinning:O.isSkinnedMesh===!0,morphTargets:$.morphAttributes.position!==void 0,morphNormals:$.morphAttributes.normal!==void 0,morphColors:$.morphAttributes.color!==void 0,morphTargetsCount:gt,morphTextureStride:xt,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:E.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:Oe,decodeVideoTexture:ce&&E.map.isVideoTexture===!0&&ve.getTransfer(E.map.colorSpace)===Ce,decodeVideoTextureEmissive:me&&E.emissiveMap.isVideoTexture===!0&&ve.getTransfer(E.emissiveMap.colorSpace)===Ce,premultipliedAlpha:E.premultipliedAlpha,doubleSided:E.side===ki,flipSided:E.side===Ln,useDepthPacking:E.depthPacking>=0,depthPacking:E.depthPacking||0,index0AttributeName:E.index0AttributeName,extensionClipCullDistance:Qt&&E.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&E.extensions.multiDraw===!0||Ut)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:E.customProgramCacheKey()};return sn.vertexUv1s=c.has(1),sn.vertexUv2s=c.has(2),sn.vertexUv3s=c.has(3),c.clear(),sn}function f(E){const b=[];if(E.shaderID?b.push(E.shaderID):(b.push(E.customVertexShaderID),b.push(E.customFragmentShaderID)),E.defines!==void 0)for(const R in E.defines)b.push(R),b.push(E.defines[R]);return E.isRawShaderMaterial===!1&&(M(b,E),S(b,E),b.push(i.outputColorSpace)),b.push(E.customProgramCacheKey),b.join()}function M(E,b){E.push(b.precision),E.push(b.outputColorSpace),E.push(b.envMapMode),E.push(b.envMapCubeUVHeight),E.push(b.mapUv),E.push(b.alphaMapUv),E.push(b.lightMapUv),E.push(b.aoMapUv),E.push(b.bumpMapUv),E.push(b.normalMapUv),E.push(b.displacementMapUv),E.push(b.emissiveMapUv),E.push(b.metalnessMapUv),E.push(b.roughnessMapUv),E.push(b.anisotropyMapUv),E.push(b.clearcoatMapUv),E.push(b.clearcoatNormalMapUv),E.push(b.clearcoatRoughnessMapUv),E.push(b.iridescenceMapUv),E.push(b.iridescenceThicknessMapUv),E.push(b.sheenColorMapUv),E.push(b.sheenRoughnessMapUv),E.push(b.specularMapUv),E.push(b.specularColorMapUv),E.push(b.specularIntensityMapUv),E.push(b.transmissionMapUv),E.push(b.thicknessMapUv),E.push(b.combine),E.push(b.fogExp2),E.push(b.sizeAttenuation),E.push(b.morphTargetsCount),E.push(b.morphAttributeCount),E.push(b.numDirLights),E.push(b.numPointLights),E.push(b.numSpotLights),E.push(b.numSpotLightMaps),E.push(b.numHemiLights),E.push(b.numRectAreaLights),E.push(b.numDirLightShadows),E.push(b.numPointLightShadows),E.push(b.numSpotLightShadows),E.push(b.numSpotLightShadowsWithMaps),E.push(b.numLightProbes),E.push(b.shadowMapType),E.push(b.toneMapping),E.push(b.numClippingPlanes),E.push(b.numClipIntersection),E.push(b.depthPacking)}function S(E,b){a.disableAll(),b.supportsVertexTextures&&a.enable(0),b.instancing&&a.enable(1),b.instancingColor&&a.enable(2),b.instancingMorph&&a.enable(3),b.matcap&&a.enable(4),b.envMap&&a.enable(5),b.normalMapObjectSpace&&a.enable(6),b.normalMapTangentSpace&&a.enable(7),b.clearcoat&&a.enable(8),b.iridescence&&a.enable(9),b.alphaTest&&a.enable(10),b.vertexColors&&a.enable(11),b.vertexAlphas&&a.enable(12),b.vertexUv1s&&a.enable(13),b.vertexUv2s&&a.enable(14),b.vertexUv3s&&a.enable(15),b.vertexTangents&&a.enable(16),b.anisotropy&&a.enable(17),b.alphaHash&&a.enable(18),b.batching&&a.enable(19),b.dispersion&&a.enable(20),b.batchingColor&&a.enable(21),E.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reverseDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),E.push(a.mask)}function x(E){const b=_[E.type];let R;if(b){const H=vi[b];R=VC.clone(H.uniforms)}else R=E.uniforms;return R}function k(E,b){let R;for(let H=0,O=h.length;H<O;H++){const q=h[H];if(q.cacheKey===b){R=q,++R.usedTimes;break}}return R===void 0&&(R=new eI(i,b,E,o),h.push(R)),R}function P(E){if(--E.usedTimes===0){const b=h.indexOf(E);h[b]=h[h.length-1],h.pop(),E.destroy()}}function A(E){l.remove(E)}function I(){l.dispose()}return{getParameters:m,getProgramCacheKey:f,getUniforms:x,acquireProgram:k,releaseProgram:P,releaseShaderCache:A,programs:h,dispose:I}}function rI(){let i=new WeakMap;function t(r){return i.has(r)}function e(r){let a=i.get(r);return a===void 0&&(a={},i.set(r,a)),a}function n(r){i.delete(r)}function s(r,a,l){i.get(r)[a]=l}function o(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:o}}function aI(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function zf(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Hf(){const i=[];let t=0;const e=[],n=[],s=[];function o(){t=0,e.length=0,n.length=0,s.length=0}function r(u,d,p,_,g,m){let f=i[t];return f===void 0?(f={id:u.id,object:u,geometry:d,material:p,groupOrder:_,renderOrder:u.renderOrder,z:g,group:m},i[t]=f):(f.id=u.id,f.object=u,f.geometry=d,f.material=p,f.groupOrder=_,f.renderOrder=u.renderOrder,f.z=g,f.group=m),t++,f}function a(u,d,p,_,g,m){const f=r(u,d,p,_,g,m);p.transmission>0?n.push(f):p.transparent===!0?s.push(f):e.push(f)}function l(u,d,p,_,g,m){const f=r(u,d,p,_,g,m);p.transmission>0?n.unshift(f):p.transparent===!0?s.unshift(f):e.unshift(f)}function c(u,d){e.length>1&&e.sort(u||aI),n.length>1&&n.sort(d||zf),s.length>1&&s.sort(d||zf)}function h(){for(let u=t,d=i.length;u<d;u++){const p=i[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:o,push:a,unshift:l,finish:h,sort:c}}function lI(){let i=new WeakMap;function t(n,s){const o=i.get(n);let r;return o===void 0?(r=new Hf,i.set(n,[r])):s>=o.length?(r=new Hf,o.push(r)):r=o[s],r}function e(){i=new WeakMap}return{get:t,dispose:e}}function cI(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new et,color:new pe};break;case"SpotLight":e={position:new et,direction:new et,color:new pe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new et,color:new pe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new et,skyColor:new pe,groundColor:new pe};break;case"RectAreaLight":e={color:new pe,position:new et,halfWidth:new et,halfHeight:new et};break}return i[t.id]=e,e}}}function hI(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xe};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xe};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let uI=0;function dI(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function fI(i){const t=new cI,e=hI(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new et);const s=new et,o=new Ve,r=new Ve;function a(c){let h=0,u=0,d=0;for(let E=0;E<9;E++)n.probe[E].set(0,0,0);let p=0,_=0,g=0,m=0,f=0,M=0,S=0,x=0,k=0,P=0,A=0;c.sort(dI);for(let E=0,b=c.length;E<b;E++){const R=c[E],H=R.color,O=R.intensity,q=R.distance,$=R.shadow&&R.shadow.map?R.shadow.map.texture:null;if(R.isAmbientLight)h+=H.r*O,u+=H.g*O,d+=H.b*O;else if(R.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(R.sh.coefficients[X],O);A++}else if(R.isDirectionalLight){const X=t.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){const j=R.shadow,Q=e.get(R);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,n.directionalShadow[p]=Q,n.directionalShadowMap[p]=$,n.directionalShadowMatrix[p]=R.shadow.matrix,M++}n.directional[p]=X,p++}else if(R.isSpotLight){const X=t.get(R);X.position.setFromMatrixPosition(R.matrixWorld),X.color.copy(H).multiplyScalar(O),X.distance=q,X.coneCos=Math.cos(R.angle),X.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),X.decay=R.decay,n.spot[g]=X;const j=R.shadow;if(R.map&&(n.spotLightMap[k]=R.map,k++,j.updateMatrices(R),R.castShadow&&P++),n.spotLightMatrix[g]=j.matrix,R.castShadow){const Q=e.get(R);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,n.spotShadow[g]=Q,n.spotShadowMap[g]=$,x++}g++}else if(R.isRectAreaLight){const X=t.get(R);X.color.copy(H).multiplyScalar(O),X.halfWidth.set(R.width*.5,0,0),X.halfHeight.set(0,R.height*.5,0),n.rectArea[m]=X,m++}else if(R.isPointLight){const X=t.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),X.distance=R.distance,X.decay=R.decay,R.castShadow){const j=R.shadow,Q=e.get(R);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,Q.shadowCameraNear=j.camera.near,Q.shadowCameraFar=j.camera.far,n.pointShadow[_]=Q,n.pointShadowMap[_]=$,n.pointShadowMatrix[_]=R.shadow.matrix,S++}n.point[_]=X,_++}else if(R.isHemisphereLight){const X=t.get(R);X.skyColor.copy(R.color).multiplyScalar(O),X.groundColor.copy(R.groundColor).multiplyScalar(O),n.hemi[f]=X,f++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Tt.LTC_FLOAT_1,n.rectAreaLTC2=Tt.LTC_FLOAT_2):(n.rectAreaLTC1=Tt.LTC_HALF_1,n.rectAreaLTC2=Tt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;const I=n.hash;(I.directionalLength!==p||I.pointLength!==_||I.spotLength!==g||I.rectAreaLength!==m||I.hemiLength!==f||I.numDirectionalShadows!==M||I.numPointShadows!==S||I.numSpotShadows!==x||I.numSpotMaps!==k||I.numLightProbes!==A)&&(n.directional.length=p,n.spot.length=g,n.rectArea.length=m,n.point.length=_,n.hemi.length=f,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.pointShadow.length=S,n.pointShadowMap.length=S,n.spotShadow.length=x,n.spotShadowMap.length=x,n.directionalShadowMatrix.length=M,n.pointShadowMatrix.length=S,n.spotLightMatrix.length=x+k-P,n.spotLightMap.length=k,n.numSpotLightShadowsWithMaps=P,n.numLightProbes=A,I.directionalLength=p,I.pointLength=_,I.spotLength=g,I.rectAreaLength=m,I.hemiLength=f,I.numDirectionalShadows=M,I.numPointShadows=S,I.numSpotShadows=x,I.numSpotMaps=k,I.numLightProbes=A,n.version=uI++)}function l(c,h){let u=0,d=0,p=0,_=0,g=0;const m=h.matrixWorldInverse;for(let f=0,M=c.length;f<M;f++){const S=c[f];if(S.isDirectionalLight){const x=n.directional[u];x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),u++}else if(S.isSpotLight){const x=n.spot[p];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),p++}else if(S.isRectAreaLight){const x=n.rectArea[_];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(m),r.identity(),o.copy(S.matrixWorld),o.premultiply(m),r.extractRotation(o),x.halfWidth.set(S.width*.5,0,0),x.halfHeight.set(0,S.height*.5,0),x.halfWidth.applyMatrix4(r),x.halfHeight.applyMatrix4(r),_++}else if(S.isPointLight){const x=n.point[d];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(m),d++}else if(S.isHemisphereLight){const x=n.hemi[g];x.direction.setFromMatrixPosition(S.matrixWorld),x.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function Vf(i){const t=new fI(i),e=[],n=[];function s(h){c.camera=h,e.length=0,n.length=0}function o(h){e.push(h)}function r(h){n.push(h)}function a(){t.setup(e)}function l(h){t.setupView(e,h)}const c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:o,pushShadow:r}}function pI(i){let t=new WeakMap;function e(s,o=0){const r=t.get(s);let a;return r===void 0?(a=new Vf(i),t.set(s,[a])):o>=r.length?(a=new Vf(i),r.push(a)):a=r[o],a}function n(){t=new WeakMap}return{get:e,dispose:n}}class mI extends Cr{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=uC,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class gI extends Cr{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const _I=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,vI=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function xI(i,t,e){let n=new Jh;const s=new xe,o=new xe,r=new $e,a=new mI({depthPacking:dC}),l=new gI,c={},h=e.maxTextureSize,u={[fs]:Ln,[Ln]:fs,[ki]:ki},d=new ps({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new xe},radius:{value:4}},vertexShader:_I,fragmentShader:vI}),p=d.clone();p.defines.HORIZONTAL_PASS=1;const _=new ms;_.setAttribute("position",new Mi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const g=new fn(_,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=xm;let f=this.type;this.render=function(P,A,I){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||P.length===0)return;const E=i.getRenderTarget(),b=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),H=i.state;H.setBlending(as),H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);const O=f!==Ni&&this.type===Ni,q=f===Ni&&this.type!==Ni;for(let $=0,X=P.length;$<X;$++){const j=P[$],Q=j.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",j,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);const at=Q.getFrameExtents();if(s.multiply(at),o.copy(Q.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(o.x=Math.floor(h/at.x),s.x=o.x*at.x,Q.mapSize.x=o.x),s.y>h&&(o.y=Math.floor(h/at.y),s.y=o.y*at.y,Q.mapSize.y=o.y)),Q.map===null||O===!0||q===!0){const gt=this.type!==Ni?{minFilter:ci,magFilter:ci}:{};Q.map!==null&&Q.map.dispose(),Q.map=new Xs(s.x,s.y,gt),Q.map.texture.name=j.name+".shadowMap",Q.camera.updateProjectionMatrix()}i.setRenderTarget(Q.map),i.clear();const lt=Q.getViewportCount();for(let gt=0;gt<lt;gt++){const xt=Q.getViewport(gt);r.set(o.x*xt.x,o.y*xt.y,o.x*xt.z,o.y*xt.w),H.viewport(r),Q.updateMatrices(j,gt),n=Q.getFrustum(),x(A,I,Q.camera,j,this.type)}Q.isPointLightShadow!==!0&&this.type===Ni&&M(Q,I),Q.needsUpdate=!1}f=this.type,m.needsUpdate=!1,i.setRenderTarget(E,b,R)};function M(P,A){const I=t.update(g);d.defines.VSM_SAMPLES!==P.blurSamples&&(d.defines.VSM_SAMPLES=P.blurSamples,p.defines.VSM_SAMPLES=P.blurSamples,d.needsUpdate=!0,p.needsUpdate=!0),P.mapPass===null&&(P.mapPass=new Xs(s.x,s.y)),d.uniforms.shadow_pass.value=P.map.texture,d.uniforms.resolution.value=P.mapSize,d.uniforms.radius.value=P.radius,i.setRenderTarget(P.mapPass),i.clear(),i.renderBufferDirect(A,null,I,d,g,null),p.uniforms.shadow_pass.value=P.mapPass.texture,p.uniforms.resolution.value=P.mapSize,p.uniforms.radius.value=P.radius,i.setRenderTarget(P.map),i.clear(),i.renderBufferDirect(A,null,I,p,g,null)}function S(P,A,I,E){let b=null;const R=I.isPointLight===!0?P.customDistanceMaterial:P.customDepthMaterial;if(R!==void 0)b=R;else if(b=I.isPointLight===!0?l:a,i.localClippingEnabled&&A.clipShadows===!0&&Array.isArray(A.clippingPlanes)&&A.clippingPlanes.length!==0||A.displacementMap&&A.displacementScale!==0||A.alphaMap&&A.alphaTest>0||A.map&&A.alphaTest>0){const H=b.uuid,O=A.uuid;let q=c[H];q===void 0&&(q={},c[H]=q);let $=q[O];$===void 0&&($=b.clone(),q[O]=$,A.addEventListener("dispose",k)),b=$}if(b.visible=A.visible,b.wireframe=A.wireframe,E===Ni?b.side=A.shadowSide!==null?A.shadowSide:A.side:b.side=A.shadowSide!==null?A.shadowSide:u[A.side],b.alphaMap=A.alphaMap,b.alphaTest=A.alphaTest,b.map=A.map,b.clipShadows=A.clipShadows,b.clippingPlanes=A.clippingPlanes,b.clipIntersection=A.clipIntersection,b.displacementMap=A.displacementMap,b.displacementScale=A.displacementScale,b.displacementBias=A.displacementBias,b.wireframeLinewidth=A.wireframeLinewidth,b.linewidth=A.linewidth,I.isPointLight===!0&&b.isMeshDistanceMaterial===!0){const H=i.properties.get(b);H.light=I}return b}function x(P,A,I,E,b){if(P.visible===!1)return;if(P.layers.test(A.layers)&&(P.isMesh||P.isLine||P.isPoints)&&(P.castShadow||P.receiveShadow&&b===Ni)&&(!P.frustumCulled||n.intersectsObject(P))){P.modelViewMatrix.multiplyMatrices(I.matrixWorldInverse,P.matrixWorld);const O=t.update(P),q=P.material;if(Array.isArray(q)){const $=O.groups;for(let X=0,j=$.length;X<j;X++){const Q=$[X],at=q[Q.materialIndex];if(at&&at.visible){const lt=S(P,at,E,b);P.onBeforeShadow(i,P,A,I,O,lt,Q),i.renderBufferDirect(I,null,O,lt,P,Q),P.onAfterShadow(i,P,A,I,O,lt,Q)}}}else if(q.visible){const $=S(P,q,E,b);P.onBeforeShadow(i,P,A,I,O,$,null),i.renderBufferDirect(I,null,O,$,P,null),P.onAfterShadow(i,P,A,I,O,$,null)}}const H=P.children;for(let O=0,q=H.length;O<q;O++)x(H[O],A,I,E,b)}function k(P){P.target.removeEventListener("dispose",k);for(const I in c){const E=c[I],b=P.target.uuid;b in E&&(E[b].dispose(),delete E[b])}}}const bI={[Cc]:Pc,[Lc]:Nc,[Dc]:Uc,[Bo]:Ic,[Pc]:Cc,[Nc]:Lc,[Uc]:Dc,[Ic]:Bo};function yI(i,t){function e(){let V=!1;const Mt=new $e;let st=null;const ct=new $e(0,0,0,0);return{setMask:function(Rt){st!==Rt&&!V&&(i.colorMask(Rt,Rt,Rt,Rt),st=Rt)},setLocked:function(Rt){V=Rt},setClear:function(Rt,Ct,Qt,Oe,sn){sn===!0&&(Rt*=Oe,Ct*=Oe,Qt*=Oe),Mt.set(Rt,Ct,Qt,Oe),ct.equals(Mt)===!1&&(i.clearColor(Rt,Ct,Qt,Oe),ct.copy(Mt))},reset:function(){V=!1,st=null,ct.set(-1,0,0,0)}}}function n(){let V=!1,Mt=!1,st=null,ct=null,Rt=null;return{setReversed:function(Ct){if(Mt!==Ct){const Qt=t.get("EXT_clip_control");Mt?Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.ZERO_TO_ONE_EXT):Qt.clipControlEXT(Qt.LOWER_LEFT_EXT,Qt.NEGATIVE_ONE_TO_ONE_EXT);const Oe=Rt;Rt=null,this.setClear(Oe)}Mt=Ct},getReversed:function(){return Mt},setTest:function(Ct){Ct?ht(i.DEPTH_TEST):Nt(i.DEPTH_TEST)},setMask:function(Ct){st!==Ct&&!V&&(i.depthMask(Ct),st=Ct)},setFunc:function(Ct){if(Mt&&(Ct=bI[Ct]),ct!==Ct){switch(Ct){case Cc:i.depthFunc(i.NEVER);break;case Pc:i.depthFunc(i.ALWAYS);break;case Lc:i.depthFunc(i.LESS);break;case Bo:i.depthFunc(i.LEQUAL);break;case Dc:i.depthFunc(i.EQUAL);break;case Ic:i.depthFunc(i.GEQUAL);break;case Nc:i.depthFunc(i.GREATER);break;case Uc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ct=Ct}},setLocked:function(Ct){V=Ct},setClear:function(Ct){Rt!==Ct&&(Mt&&(Ct=1-Ct),i.clearDepth(Ct),Rt=Ct)},reset:function(){V=!1,st=null,ct=null,Rt=null,Mt=!1}}}function s(){let V=!1,Mt=null,st=null,ct=null,Rt=null,Ct=null,Qt=null,Oe=null,sn=null;return{setTest:function(Me){V||(Me?ht(i.STENCIL_TEST):Nt(i.STENCIL_TEST))},setMask:function(Me){Mt!==Me&&!V&&(i.stencilMask(Me),Mt=Me)},setFunc:function(Me,Ze,Ie){(st!==Me||ct!==Ze||Rt!==Ie)&&(i.stencilFunc(Me,Ze,Ie),st=Me,ct=Ze,Rt=Ie)},setOp:function(Me,Ze,Ie){(Ct!==Me||Qt!==Ze||Oe!==Ie)&&(i.stencilOp(Me,Ze,Ie),Ct=Me,Qt=Ze,Oe=Ie)},setLocked:function(Me){V=Me},setClear:function(Me){sn!==Me&&(i.clearStencil(Me),sn=Me)},reset:function(){V=!1,Mt=null,st=null,ct=null,Rt=null,Ct=null,Qt=null,Oe=null,sn=null}}}const o=new e,r=new n,a=new s,l=new WeakMap,c=new WeakMap;let h={},u={},d=new WeakMap,p=[],_=null,g=!1,m=null,f=null,M=null,S=null,x=null,k=null,P=null,A=new pe(0,0,0),I=0,E=!1,b=null,R=null,H=null,O=null,q=null;const $=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let X=!1,j=0;const Q=i.getParameter(i.VERSION);Q.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(Q)[1]),X=j>=1):Q.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),X=j>=2);let at=null,lt={};const gt=i.getParameter(i.SCISSOR_BOX),xt=i.getParameter(i.VIEWPORT),mt=new $e().fromArray(gt),ot=new $e().fromArray(xt);function ut(V,Mt,st,ct){const Rt=new Uint8Array(4),Ct=i.createTexture();i.bindTexture(V,Ct),i.texParameteri(V,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(V,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Qt=0;Qt<st;Qt++)V===i.TEXTURE_3D||V===i.TEXTURE_2D_ARRAY?i.texImage3D(Mt,0,i.RGBA,1,1,ct,0,i.RGBA,i.UNSIGNED_BYTE,Rt):i.texImage2D(Mt+Qt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Rt);return Ct}const _t={};_t[i.TEXTURE_2D]=ut(i.TEXTURE_2D,i.TEXTURE_2D,1),_t[i.TEXTURE_CUBE_MAP]=ut(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),_t[i.TEXTURE_2D_ARRAY]=ut(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),_t[i.TEXTURE_3D]=ut(i.TEXTURE_3D,i.TEXTURE_3D,1,1),o.setClear(0,0,0,1),r.setClear(1),a.setClear(0),ht(i.DEPTH_TEST),r.setFunc(Bo),te(!1),ie($d),ht(i.CULL_FACE),G(as);function ht(V){h[V]!==!0&&(i.enable(V),h[V]=!0)}function Nt(V){h[V]!==!1&&(i.disable(V),h[V]=!1)}function zt(V,Mt){return u[V]!==Mt?(i.bindFramebuffer(V,Mt),u[V]=Mt,V===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=Mt),V===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=Mt),!0):!1}function Ut(V,Mt){let st=p,ct=!1;if(V){st=d.get(Mt),st===void 0&&(st=[],d.set(Mt,st));const Rt=V.textures;if(st.length!==Rt.length||st[0]!==i.COLOR_ATTACHMENT0){for(let Ct=0,Qt=Rt.length;Ct<Qt;Ct++)st[Ct]=i.COLOR_ATTACHMENT0+Ct;st.length=Rt.length,ct=!0}}else st[0]!==i.BACK&&(st[0]=i.BACK,ct=!0);ct&&i.drawBuffers(st)}function ce(V){return _!==V?(i.useProgram(V),_=V,!0):!1}const Jt={[Us]:i.FUNC_ADD,[OR]:i.FUNC_SUBTRACT,[BR]:i.FUNC_REVERSE_SUBTRACT};Jt[zR]=i.MIN,Jt[HR]=i.MAX;const he={[VR]:i.ZERO,[GR]:i.ONE,[WR]:i.SRC_COLOR,[Ac]:i.SRC_ALPHA,[KR]:i.SRC_ALPHA_SATURATE,[jR]:i.DST_COLOR,[qR]:i.DST_ALPHA,[$R]:i.ONE_MINUS_SRC_COLOR,[Rc]:i.ONE_MINUS_SRC_ALPHA,[YR]:i.ONE_MINUS_DST_COLOR,[XR]:i.ONE_MINUS_DST_ALPHA,[ZR]:i.CONSTANT_COLOR,[JR]:i.ONE_MINUS_CONSTANT_COLOR,[QR]:i.CONSTANT_ALPHA,[tC]:i.ONE_MINUS_CONSTANT_ALPHA};function G(V,Mt,st,ct,Rt,Ct,Qt,Oe,sn,Me){if(V===as){g===!0&&(Nt(i.BLEND),g=!1);return}if(g===!1&&(ht(i.BLEND),g=!0),V!==FR){if(V!==m||Me!==E){if((f!==Us||x!==Us)&&(i.blendEquation(i.FUNC_ADD),f=Us,x=Us),Me)switch(V){case Lo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case qd:i.blendFunc(i.ONE,i.ONE);break;case Xd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case jd:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",V);break}else switch(V){case Lo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case qd:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case Xd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case jd:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",V);break}M=null,S=null,k=null,P=null,A.set(0,0,0),I=0,m=V,E=Me}return}Rt=Rt||Mt,Ct=Ct||st,Qt=Qt||ct,(Mt!==f||Rt!==x)&&(i.blendEquationSeparate(Jt[Mt],Jt[Rt]),f=Mt,x=Rt),(st!==M||ct!==S||Ct!==k||Qt!==P)&&(i.blendFuncSeparate(he[st],he[ct],he[Ct],he[Qt]),M=st,S=ct,k=Ct,P=Qt),(Oe.equals(A)===!1||sn!==I)&&(i.blendColor(Oe.r,Oe.g,Oe.b,sn),A.copy(Oe),I=sn),m=V,E=!1}function Ke(V,Mt){V.side===ki?Nt(i.CULL_FACE):ht(i.CULL_FACE);let st=V.side===Ln;Mt&&(st=!st),te(st),V.blending===Lo&&V.transparent===!1?G(as):G(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),r.setFunc(V.depthFunc),r.setTest(V.depthTest),r.setMask(V.depthWrite),o.setMask(V.colorWrite);const ct=V.stencilWrite;a.setTest(ct),ct&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),me(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?ht(i.SAMPLE_ALPHA_TO_COVERAGE):Nt(i.SAMPLE_ALPHA_TO_COVERAGE)}function te(V){b!==V&&(V?i.frontFace(i.CW):i.frontFace(i.CCW),b=V)}function ie(V){V!==UR?(ht(i.CULL_FACE),V!==R&&(V===$d?i.cullFace(i.BACK):V===kR?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Nt(i.CULL_FACE),R=V}function Wt(V){V!==H&&(X&&i.lineWidth(V),H=V)}function me(V,Mt,st){V?(ht(i.POLYGON_OFFSET_FILL),(O!==Mt||q!==st)&&(i.polygonOffset(Mt,st),O=Mt,q=st)):Nt(i.POLYGON_OFFSET_FILL)}function Dt(V){V?ht(i.SCISSOR_TEST):Nt(i.SCISSOR_TEST)}function D(V){V===void 0&&(V=i.TEXTURE0+$-1),at!==V&&(i.activeTexture(V),at=V)}function w(V,Mt,st){st===void 0&&(at===null?st=i.TEXTURE0+$-1:st=at);let ct=lt[st];ct===void 0&&(ct={type:void 0,texture:void 0},lt[st]=ct),(ct.type!==V||ct.texture!==Mt)&&(at!==st&&(i.activeTexture(st),at=st),i.bindTexture(V,Mt||_t[V]),ct.type=V,ct.texture=Mt)}function tt(){const V=lt[at];V!==void 0&&V.type!==void 0&&(i.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function nt(){try{i.compressedTexImage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function Y(){try{i.compressedTexImage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function it(){try{i.texSubImage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function St(){try{i.texSubImage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function bt(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function At(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function Zt(){try{i.texStorage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function pt(){try{i.texStorage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function yt(){try{i.texImage2D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function Ot(){try{i.texImage3D.apply(i,arguments)}catch(V){console.error("THREE.WebGLState:",V)}}function Ht(V){mt.equals(V)===!1&&(i.scissor(V.x,V.y,V.z,V.w),mt.copy(V))}function Et(V){ot.equals(V)===!1&&(i.viewport(V.x,V.y,V.z,V.w),ot.copy(V))}function oe(V,Mt){let st=c.get(Mt);st===void 0&&(st=new WeakMap,c.set(Mt,st));let ct=st.get(V);ct===void 0&&(ct=i.getUniformBlockIndex(Mt,V.name),st.set(V,ct))}function Yt(V,Mt){const ct=c.get(Mt).get(V);l.get(Mt)!==ct&&(i.uniformBlockBinding(Mt,ct,V.__bindingPointIndex),l.set(Mt,ct))}function ge(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),r.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},at=null,lt={},u={},d=new WeakMap,p=[],_=null,g=!1,m=null,f=null,M=null,S=null,x=null,k=null,P=null,A=new pe(0,0,0),I=0,E=!1,b=null,R=null,H=null,O=null,q=null,mt.set(0,0,i.canvas.width,i.canvas.height),ot.set(0,0,i.canvas.width,i.canvas.height),o.reset(),r.reset(),a.reset()}return{buffers:{color:o,depth:r,stencil:a},enable:ht,disable:Nt,bindFramebuffer:zt,drawBuffers:Ut,useProgram:ce,setBlending:G,setMaterial:Ke,setFlipSided:te,setCullFace:ie,setLineWidth:Wt,setPolygonOffset:me,setScissorTest:Dt,activeTexture:D,bindTexture:w,unbindTexture:tt,compressedTexImage2D:nt,compressedTexImage3D:Y,texImage2D:yt,texImage3D:Ot,updateUBOMapping:oe,uniformBlockBinding:Yt,texStorage2D:Zt,texStorage3D:pt,texSubImage2D:it,texSubImage3D:St,compressedTexSubImage2D:bt,compressedTexSubImage3D:At,scissor:Ht,viewport:Et,reset:ge}}function Gf(i,t,e,n){const s=MI(n);switch(e){case Tm:return i*t;case Rm:return i*t;case Cm:return i*t*2;case Pm:return i*t/s.components*s.byteLength;case qh:return i*t/s.components*s.byteLength;case Lm:return i*t*2/s.components*s.byteLength;case Xh:return i*t*2/s.components*s.byteLength;case Am:return i*t*3/s.components*s.byteLength;case li:return i*t*4/s.components*s.byteLength;case jh:return i*t*4/s.components*s.byteLength;case ba:case ya:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ma:case Sa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case zc:case Vc:return Math.max(i,16)*Math.max(t,8)/4;case Bc:case Hc:return Math.max(i,8)*Math.max(t,8)/2;case Gc:case Wc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case $c:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case qc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Xc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case jc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Yc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Kc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Zc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Qc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case th:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case eh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case nh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case ih:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case sh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case oh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case wa:case rh:case ah:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Dm:case lh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case ch:case hh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function MI(i){switch(i){case Wi:case Sm:return{byteLength:1,components:1};case wr:case wm:case Er:return{byteLength:2,components:1};case Wh:case $h:return{byteLength:2,components:4};case qs:case Gh:case Fi:return{byteLength:4,components:1};case Em:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function SI(i,t,e,n,s,o,r){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new xe,h=new WeakMap;let u;const d=new WeakMap;let p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(D,w){return p?new OffscreenCanvas(D,w):Oa("canvas")}function g(D,w,tt){let nt=1;const Y=Dt(D);if((Y.width>tt||Y.height>tt)&&(nt=tt/Math.max(Y.width,Y.height)),nt<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){const it=Math.floor(nt*Y.width),St=Math.floor(nt*Y.height);u===void 0&&(u=_(it,St));const bt=w?_(it,St):u;return bt.width=it,bt.height=St,bt.getContext("2d").drawImage(D,0,0,it,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+Y.width+"x"+Y.height+") to ("+it+"x"+St+")."),bt}else return"data"in D&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+Y.width+"x"+Y.height+")."),D;return D}function m(D){return D.generateMipmaps}function f(D){i.generateMipmap(D)}function M(D){return D.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?i.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(D,w,tt,nt,Y=!1){if(D!==null){if(i[D]!==void 0)return i[D];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let it=w;if(w===i.RED&&(tt===i.FLOAT&&(it=i.R32F),tt===i.HALF_FLOAT&&(it=i.R16F),tt===i.UNSIGNED_BYTE&&(it=i.R8)),w===i.RED_INTEGER&&(tt===i.UNSIGNED_BYTE&&(it=i.R8UI),tt===i.UNSIGNED_SHORT&&(it=i.R16UI),tt===i.UNSIGNED_INT&&(it=i.R32UI),tt===i.BYTE&&(it=i.R8I),tt===i.SHORT&&(it=i.R16I),tt===i.INT&&(it=i.R32I)),w===i.RG&&(tt===i.FLOAT&&(it=i.RG32F),tt===i.HALF_FLOAT&&(it=i.RG16F),tt===i.UNSIGNED_BYTE&&(it=i.RG8)),w===i.RG_INTEGER&&(tt===i.UNSIGNED_BYTE&&(it=i.RG8UI),tt===i.UNSIGNED_SHORT&&(it=i.RG16UI),tt===i.UNSIGNED_INT&&(it=i.RG32UI),tt===i.BYTE&&(it=i.RG8I),tt===i.SHORT&&(it=i.RG16I),tt===i.INT&&(it=i.RG32I)),w===i.RGB_INTEGER&&(tt===i.UNSIGNED_BYTE&&(it=i.RGB8UI),tt===i.UNSIGNED_SHORT&&(it=i.RGB16UI),tt===i.UNSIGNED_INT&&(it=i.RGB32UI),tt===i.BYTE&&(it=i.RGB8I),tt===i.SHORT&&(it=i.RGB16I),tt===i.INT&&(it=i.RGB32I)),w===i.RGBA_INTEGER&&(tt===i.UNSIGNED_BYTE&&(it=i.RGBA8UI),tt===i.UNSIGNED_SHORT&&(it=i.RGBA16UI),tt===i.UNSIGNED_INT&&(it=i.RGBA32UI),tt===i.BYTE&&(it=i.RGBA8I),tt===i.SHORT&&(it=i.RGBA16I),tt===i.INT&&(it=i.RGBA32I)),w===i.RGB&&tt===i.UNSIGNED_INT_5_9_9_9_REV&&(it=i.RGB9_E5),w===i.RGBA){const St=Y?el:ve.getTransfer(nt);tt===i.FLOAT&&(it=i.RGBA32F),tt===i.HALF_FLOAT&&(it=i.RGBA16F),tt===i.UNSIGNED_BYTE&&(it=St===Ce?i.SRGB8_ALPHA8:i.RGBA8),tt===i.UNSIGNED_SHORT_4_4_4_4&&(it=i.RGBA4),tt===i.UNSIGNED_SHORT_5_5_5_1&&(it=i.RGB5_A1)}return(it===i.R16F||it===i.R32F||it===i.RG16F||it===i.RG32F||it===i.RGBA16F||it===i.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function x(D,w){let tt;return D?w===null||w===qs||w===Vo?tt=i.DEPTH24_STENCIL8:w===Fi?tt=i.DEPTH32F_STENCIL8:w===wr&&(tt=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===qs||w===Vo?tt=i.DEPTH_COMPONENT24:w===Fi?tt=i.DEPTH_COMPONENT32F:w===wr&&(tt=i.DEPTH_COMPONENT16),tt}function k(D,w){return m(D)===!0||D.isFramebufferTexture&&D.minFilter!==ci&&D.minFilter!==xi?Math.log2(Math.max(w.width,w.height))+1:D.mipmaps!==void 0&&D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?w.mipmaps.length:1}function P(D){const w=D.target;w.removeEventListener("dispose",P),I(w),w.isVideoTexture&&h.delete(w)}function A(D){const w=D.target;w.removeEventListener("dispose",A),b(w)}function I(D){const w=n.get(D);if(w.__webglInit===void 0)return;const tt=D.source,nt=d.get(tt);if(nt){const Y=nt[w.__cacheKey];Y.usedTimes--,Y.usedTimes===0&&E(D),Object.keys(nt).length===0&&d.delete(tt)}n.remove(D)}function E(D){const w=n.get(D);i.deleteTexture(w.__webglTexture);const tt=D.source,nt=d.get(tt);delete nt[w.__cacheKey],r.memory.textures--}function b(D){const w=n.get(D);if(D.depthTexture&&(D.depthTexture.dispose(),n.remove(D.depthTexture)),D.isWebGLCubeRenderTarget)for(let nt=0;nt<6;nt++){if(Array.isArray(w.__webglFramebuffer[nt]))for(let Y=0;Y<w.__webglFramebuffer[nt].length;Y++)i.deleteFramebuffer(w.__webglFramebuffer[nt][Y]);else i.deleteFramebuffer(w.__webglFramebuffer[nt]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[nt])}else{if(Array.isArray(w.__webglFramebuffer))for(let nt=0;nt<w.__webglFramebuffer.length;nt++)i.deleteFramebuffer(w.__webglFramebuffer[nt]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let nt=0;nt<w.__webglColorRenderbuffer.length;nt++)w.__webglColorRenderbuffer[nt]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[nt]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}const tt=D.textures;for(let nt=0,Y=tt.length;nt<Y;nt++){const it=n.get(tt[nt]);it.__webglTexture&&(i.deleteTexture(it.__webglTexture),r.memory.textures--),n.remove(tt[nt])}n.remove(D)}let R=0;function H(){R=0}function O(){const D=R;return D>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+D+" texture units while this GPU supports only "+s.maxTextures),R+=1,D}function q(D){const w=[];return w.push(D.wrapS),w.push(D.wrapT),w.push(D.wrapR||0),w.push(D.magFilter),w.push(D.minFilter),w.push(D.anisotropy),w.push(D.internalFormat),w.push(D.format),w.push(D.type),w.push(D.generateMipmaps),w.push(D.premultiplyAlpha),w.push(D.flipY),w.push(D.unpackAlignment),w.push(D.colorSpace),w.join()}function $(D,w){const tt=n.get(D);if(D.isVideoTexture&&Wt(D),D.isRenderTargetTexture===!1&&D.version>0&&tt.__version!==D.version){const nt=D.image;if(nt===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(nt.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ot(tt,D,w);return}}e.bindTexture(i.TEXTURE_2D,tt.__webglTexture,i.TEXTURE0+w)}function X(D,w){const tt=n.get(D);if(D.version>0&&tt.__version!==D.version){ot(tt,D,w);return}e.bindTexture(i.TEXTURE_2D_ARRAY,tt.__webglTexture,i.TEXTURE0+w)}function j(D,w){const tt=n.get(D);if(D.version>0&&tt.__version!==D.version){ot(tt,D,w);return}e.bindTexture(i.TEXTURE_3D,tt.__webglTexture,i.TEXTURE0+w)}function Q(D,w){const tt=n.get(D);if(D.version>0&&tt.__version!==D.version){ut(tt,D,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,tt.__webglTexture,i.TEXTURE0+w)}const at={[ka]:i.REPEAT,[Fs]:i.CLAMP_TO_EDGE,[Oc]:i.MIRRORED_REPEAT},lt={[ci]:i.NEAREST,[hC]:i.NEAREST_MIPMAP_NEAREST,[qr]:i.NEAREST_MIPMAP_LINEAR,[xi]:i.LINEAR,[Cl]:i.LINEAR_MIPMAP_NEAREST,[Os]:i.LINEAR_MIPMAP_LINEAR},gt={[pC]:i.NEVER,[bC]:i.ALWAYS,[mC]:i.LESS,[Nm]:i.LEQUAL,[gC]:i.EQUAL,[xC]:i.GEQUAL,[_C]:i.GREATER,[vC]:i.NOTEQUAL};function xt(D,w){if(w.type===Fi&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===xi||w.magFilter===Cl||w.magFilter===qr||w.magFilter===Os||w.minFilter===xi||w.minFilter===Cl||w.minFilter===qr||w.minFilter===Os)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(D,i.TEXTURE_WRAP_S,at[w.wrapS]),i.texParameteri(D,i.TEXTURE_WRAP_T,at[w.wrapT]),(D===i.TEXTURE_3D||D===i.TEXTURE_2D_ARRAY)&&i.texParameteri(D,i.TEXTURE_WRAP_R,at[w.wrapR]),i.texParameteri(D,i.TEXTURE_MAG_FILTER,lt[w.magFilter]),i.texParameteri(D,i.TEXTURE_MIN_FILTER,lt[w.minFilter]),w.compareFunction&&(i.texParameteri(D,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(D,i.TEXTURE_COMPARE_FUNC,gt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===ci||w.minFilter!==qr&&w.minFilter!==Os||w.type===Fi&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){const tt=t.get("EXT_texture_filter_anisotropic");i.texParameterf(D,tt.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function mt(D,w){let tt=!1;D.__webglInit===void 0&&(D.__webglInit=!0,w.addEventListener("dispose",P));const nt=w.source;let Y=d.get(nt);Y===void 0&&(Y={},d.set(nt,Y));const it=q(w);if(it!==D.__cacheKey){Y[it]===void 0&&(Y[it]={texture:i.createTexture(),usedTimes:0},r.memory.textures++,tt=!0),Y[it].usedTimes++;const St=Y[D.__cacheKey];St!==void 0&&(Y[D.__cacheKey].usedTimes--,St.usedTimes===0&&E(w)),D.__cacheKey=it,D.__webglTexture=Y[it].texture}return tt}function ot(D,w,tt){let nt=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(nt=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(nt=i.TEXTURE_3D);const Y=mt(D,w),it=w.source;e.bindTexture(nt,D.__webglTexture,i.TEXTURE0+tt);const St=n.get(it);if(it.version!==St.__version||Y===!0){e.activeTexture(i.TEXTURE0+tt);const bt=ve.getPrimaries(ve.workingColorSpace),At=w.colorSpace===os?null:ve.getPrimaries(w.colorSpace),Zt=w.colorSpace===os||bt===At?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Zt);let pt=g(w.image,!1,s.maxTextureSize);pt=me(w,pt);const yt=o.convert(w.format,w.colorSpace),Ot=o.convert(w.type);let Ht=S(w.internalFormat,yt,Ot,w.colorSpace,w.isVideoTexture);xt(nt,w);let Et;const oe=w.mipmaps,Yt=w.isVideoTexture!==!0,ge=St.__version===void 0||Y===!0,V=it.dataReady,Mt=k(w,pt);if(w.isDepthTexture)Ht=x(w.format===Go,w.type),ge&&(Yt?e.texStorage2D(i.TEXTURE_2D,1,Ht,pt.width,pt.height):e.texImage2D(i.TEXTURE_2D,0,Ht,pt.width,pt.height,0,yt,Ot,null));else if(w.isDataTexture)if(oe.length>0){Yt&&ge&&e.texStorage2D(i.TEXTURE_2D,Mt,Ht,oe[0].width,oe[0].height);for(let st=0,ct=oe.length;st<ct;st++)Et=oe[st],Yt?V&&e.texSubImage2D(i.TEXTURE_2D,st,0,0,Et.width,Et.height,yt,Ot,Et.data):e.texImage2D(i.TEXTURE_2D,st,Ht,Et.width,Et.height,0,yt,Ot,Et.data);w.generateMipmaps=!1}else Yt?(ge&&e.texStorage2D(i.TEXTURE_2D,Mt,Ht,pt.width,pt.height),V&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,pt.width,pt.height,yt,Ot,pt.data)):e.texImage2D(i.TEXTURE_2D,0,Ht,pt.width,pt.height,0,yt,Ot,pt.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){Yt&&ge&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Mt,Ht,oe[0].width,oe[0].height,pt.depth);for(let st=0,ct=oe.length;st<ct;st++)if(Et=oe[st],w.format!==li)if(yt!==null)if(Yt){if(V)if(w.layerUpdates.size>0){const Rt=Gf(Et.width,Et.height,w.format,w.type);for(const Ct of w.layerUpdates){const Qt=Et.data.subarray(Ct*Rt/Et.data.BYTES_PER_ELEMENT,(Ct+1)*Rt/Et.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,st,0,0,Ct,Et.width,Et.height,1,yt,Qt)}w.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,st,0,0,0,Et.width,Et.height,pt.depth,yt,Et.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,st,Ht,Et.width,Et.height,pt.depth,0,Et.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Yt?V&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,st,0,0,0,Et.width,Et.height,pt.depth,yt,Ot,Et.data):e.texImage3D(i.TEXTURE_2D_ARRAY,st,Ht,Et.width,Et.height,pt.depth,0,yt,Ot,Et.data)}else{Yt&&ge&&e.texStorage2D(i.TEXTURE_2D,Mt,Ht,oe[0].width,oe[0].height);for(let st=0,ct=oe.length;st<ct;st++)Et=oe[st],w.format!==li?yt!==null?Yt?V&&e.compressedTexSubImage2D(i.TEXTURE_2D,st,0,0,Et.width,Et.height,yt,Et.data):e.compressedTexImage2D(i.TEXTURE_2D,st,Ht,Et.width,Et.height,0,Et.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Yt?V&&e.texSubImage2D(i.TEXTURE_2D,st,0,0,Et.width,Et.height,yt,Ot,Et.data):e.texImage2D(i.TEXTURE_2D,st,Ht,Et.width,Et.height,0,yt,Ot,Et.data)}else if(w.isDataArrayTexture)if(Yt){if(ge&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Mt,Ht,pt.width,pt.height,pt.depth),V)if(w.layerUpdates.size>0){const st=Gf(pt.width,pt.height,w.format,w.type);for(const ct of w.layerUpdates){const Rt=pt.data.subarray(ct*st/pt.data.BYTES_PER_ELEMENT,(ct+1)*st/pt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ct,pt.width,pt.height,1,yt,Ot,Rt)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,pt.width,pt.height,pt.depth,yt,Ot,pt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ht,pt.width,pt.height,pt.depth,0,yt,Ot,pt.data);else if(w.isData3DTexture)Yt?(ge&&e.texStorage3D(i.TEXTURE_3D,Mt,Ht,pt.width,pt.height,pt.depth),V&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,pt.width,pt.height,pt.depth,yt,Ot,pt.data)):e.texImage3D(i.TEXTURE_3D,0,Ht,pt.width,pt.height,pt.depth,0,yt,Ot,pt.data);else if(w.isFramebufferTexture){if(ge)if(Yt)e.texStorage2D(i.TEXTURE_2D,Mt,Ht,pt.width,pt.height);else{let st=pt.width,ct=pt.height;for(let Rt=0;Rt<Mt;Rt++)e.texImage2D(i.TEXTURE_2D,Rt,Ht,st,ct,0,yt,Ot,null),st>>=1,ct>>=1}}else if(oe.length>0){if(Yt&&ge){const st=Dt(oe[0]);e.texStorage2D(i.TEXTURE_2D,Mt,Ht,st.width,st.height)}for(let st=0,ct=oe.length;st<ct;st++)Et=oe[st],Yt?V&&e.texSubImage2D(i.TEXTURE_2D,st,0,0,yt,Ot,Et):e.texImage2D(i.TEXTURE_2D,st,Ht,yt,Ot,Et);w.generateMipmaps=!1}else if(Yt){if(ge){const st=Dt(pt);e.texStorage2D(i.TEXTURE_2D,Mt,Ht,st.width,st.height)}V&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,yt,Ot,pt)}else e.texImage2D(i.TEXTURE_2D,0,Ht,yt,Ot,pt);m(w)&&f(nt),St.__version=it.version,w.onUpdate&&w.onUpdate(w)}D.__version=w.version}function ut(D,w,tt){if(w.image.length!==6)return;const nt=mt(D,w),Y=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,D.__webglTexture,i.TEXTURE0+tt);const it=n.get(Y);if(Y.version!==it.__version||nt===!0){e.activeTexture(i.TEXTURE0+tt);const St=ve.getPrimaries(ve.workingColorSpace),bt=w.colorSpace===os?null:ve.getPrimaries(w.colorSpace),At=w.colorSpace===os||St===bt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,At);const Zt=w.isCompressedTexture||w.image[0].isCompressedTexture,pt=w.image[0]&&w.image[0].isDataTexture,yt=[];for(let ct=0;ct<6;ct++)!Zt&&!pt?yt[ct]=g(w.image[ct],!0,s.maxCubemapSize):yt[ct]=pt?w.image[ct].image:w.image[ct],yt[ct]=me(w,yt[ct]);const Ot=yt[0],Ht=o.convert(w.format,w.colorSpace),Et=o.convert(w.type),oe=S(w.internalFormat,Ht,Et,w.colorSpace),Yt=w.isVideoTexture!==!0,ge=it.__version===void 0||nt===!0,V=Y.dataReady;let Mt=k(w,Ot);xt(i.TEXTURE_CUBE_MAP,w);let st;if(Zt){Yt&&ge&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Mt,oe,Ot.width,Ot.height);for(let ct=0;ct<6;ct++){st=yt[ct].mipmaps;for(let Rt=0;Rt<st.length;Rt++){const Ct=st[Rt];w.format!==li?Ht!==null?Yt?V&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt,0,0,Ct.width,Ct.height,Ht,Ct.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt,oe,Ct.width,Ct.height,0,Ct.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt,0,0,Ct.width,Ct.height,Ht,Et,Ct.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt,oe,Ct.width,Ct.height,0,Ht,Et,Ct.data)}}}else{if(st=w.mipmaps,Yt&&ge){st.length>0&&Mt++;const ct=Dt(yt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Mt,oe,ct.width,ct.height)}for(let ct=0;ct<6;ct++)if(pt){Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,0,0,0,yt[ct].width,yt[ct].height,Ht,Et,yt[ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,0,oe,yt[ct].width,yt[ct].height,0,Ht,Et,yt[ct].data);for(let Rt=0;Rt<st.length;Rt++){const Qt=st[Rt].image[ct].image;Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt+1,0,0,Qt.width,Qt.height,Ht,Et,Qt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt+1,oe,Qt.width,Qt.height,0,Ht,Et,Qt.data)}}else{Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,0,0,0,Ht,Et,yt[ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,0,oe,Ht,Et,yt[ct]);for(let Rt=0;Rt<st.length;Rt++){const Ct=st[Rt];Yt?V&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt+1,0,0,Ht,Et,Ct.image[ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ct,Rt+1,oe,Ht,Et,Ct.image[ct])}}}m(w)&&f(i.TEXTURE_CUBE_MAP),it.__version=Y.version,w.onUpdate&&w.onUpdate(w)}D.__version=w.version}function _t(D,w,tt,nt,Y,it){const St=o.convert(tt.format,tt.colorSpace),bt=o.convert(tt.type),At=S(tt.internalFormat,St,bt,tt.colorSpace),Zt=n.get(w),pt=n.get(tt);if(pt.__renderTarget=w,!Zt.__hasExternalTextures){const yt=Math.max(1,w.width>>it),Ot=Math.max(1,w.height>>it);Y===i.TEXTURE_3D||Y===i.TEXTURE_2D_ARRAY?e.texImage3D(Y,it,At,yt,Ot,w.depth,0,St,bt,null):e.texImage2D(Y,it,At,yt,Ot,0,St,bt,null)}e.bindFramebuffer(i.FRAMEBUFFER,D),ie(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,nt,Y,pt.__webglTexture,0,te(w)):(Y===i.TEXTURE_2D||Y>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Y<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,nt,Y,pt.__webglTexture,it),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ht(D,w,tt){if(i.bindRenderbuffer(i.RENDERBUFFER,D),w.depthBuffer){const nt=w.depthTexture,Y=nt&&nt.isDepthTexture?nt.type:null,it=x(w.stencilBuffer,Y),St=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,bt=te(w);ie(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,bt,it,w.width,w.height):tt?i.renderbufferStorageMultisample(i.RENDERBUFFER,bt,it,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,it,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,D)}else{const nt=w.textures;for(let Y=0;Y<nt.length;Y++){const it=nt[Y],St=o.convert(it.format,it.colorSpace),bt=o.convert(it.type),At=S(it.internalFormat,St,bt,it.colorSpace),Zt=te(w);tt&&ie(w)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Zt,At,w.width,w.height):ie(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Zt,At,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,At,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Nt(D,w){if(w&&w.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,D),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const nt=n.get(w.depthTexture);nt.__renderTarget=w,(!nt.__webglTexture||w.depthTexture.image.width!==w.width||w.depthTexture.image.height!==w.height)&&(w.depthTexture.image.width=w.width,w.depthTexture.image.height=w.height,w.depthTexture.needsUpdate=!0),$(w.depthTexture,0);const Y=nt.__webglTexture,it=te(w);if(w.depthTexture.format===Do)ie(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,Y,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,Y,0);else if(w.depthTexture.format===Go)ie(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,Y,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,Y,0);else throw new Error("Unknown depthTexture format")}function zt(D){const w=n.get(D),tt=D.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==D.depthTexture){const nt=D.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),nt){const Y=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,nt.removeEventListener("dispose",Y)};nt.addEventListener("dispose",Y),w.__depthDisposeCallback=Y}w.__boundDepthTexture=nt}if(D.depthTexture&&!w.__autoAllocateDepthBuffer){if(tt)throw new Error("target.depthTexture not supported in Cube render targets");Nt(w.__webglFramebuffer,D)}else if(tt){w.__webglDepthbuffer=[];for(let nt=0;nt<6;nt++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[nt]),w.__webglDepthbuffer[nt]===void 0)w.__webglDepthbuffer[nt]=i.createRenderbuffer(),ht(w.__webglDepthbuffer[nt],D,!1);else{const Y=D.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,it=w.__webglDepthbuffer[nt];i.bindRenderbuffer(i.RENDERBUFFER,it),i.framebufferRenderbuffer(i.FRAMEBUFFER,Y,i.RENDERBUFFER,it)}}else if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),ht(w.__webglDepthbuffer,D,!1);else{const nt=D.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Y=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,Y),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,Y)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ut(D,w,tt){const nt=n.get(D);w!==void 0&&_t(nt.__webglFramebuffer,D,D.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),tt!==void 0&&zt(D)}function ce(D){const w=D.texture,tt=n.get(D),nt=n.get(w);D.addEventListener("dispose",A);const Y=D.textures,it=D.isWebGLCubeRenderTarget===!0,St=Y.length>1;if(St||(nt.__webglTexture===void 0&&(nt.__webglTexture=i.createTexture()),nt.__version=w.version,r.memory.textures++),it){tt.__webglFramebuffer=[];for(let bt=0;bt<6;bt++)if(w.mipmaps&&w.mipmaps.length>0){tt.__webglFramebuffer[bt]=[];for(let At=0;At<w.mipmaps.length;At++)tt.__webglFramebuffer[bt][At]=i.createFramebuffer()}else tt.__webglFramebuffer[bt]=i.createFramebuffer()}else{if(w.mipmaps&&w.mipmaps.length>0){tt.__webglFramebuffer=[];for(let bt=0;bt<w.mipmaps.length;bt++)tt.__webglFramebuffer[bt]=i.createFramebuffer()}else tt.__webglFramebuffer=i.createFramebuffer();if(St)for(let bt=0,At=Y.length;bt<At;bt++){const Zt=n.get(Y[bt]);Zt.__webglTexture===void 0&&(Zt.__webglTexture=i.createTexture(),r.memory.textures++)}if(D.samples>0&&ie(D)===!1){tt.__webglMultisampledFramebuffer=i.createFramebuffer(),tt.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,tt.__webglMultisampledFramebuffer);for(let bt=0;bt<Y.length;bt++){const At=Y[bt];tt.__webglColorRenderbuffer[bt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,tt.__webglColorRenderbuffer[bt]);const Zt=o.convert(At.format,At.colorSpace),pt=o.convert(At.type),yt=S(At.internalFormat,Zt,pt,At.colorSpace,D.isXRRenderTarget===!0),Ot=te(D);i.renderbufferStorageMultisample(i.RENDERBUFFER,Ot,yt,D.width,D.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.RENDERBUFFER,tt.__webglColorRenderbuffer[bt])}i.bindRenderbuffer(i.RENDERBUFFER,null),D.depthBuffer&&(tt.__webglDepthRenderbuffer=i.createRenderbuffer(),ht(tt.__webglDepthRenderbuffer,D,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(it){e.bindTexture(i.TEXTURE_CUBE_MAP,nt.__webglTexture),xt(i.TEXTURE_CUBE_MAP,w);for(let bt=0;bt<6;bt++)if(w.mipmaps&&w.mipmaps.length>0)for(let At=0;At<w.mipmaps.length;At++)_t(tt.__webglFramebuffer[bt][At],D,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+bt,At);else _t(tt.__webglFramebuffer[bt],D,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0);m(w)&&f(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let bt=0,At=Y.length;bt<At;bt++){const Zt=Y[bt],pt=n.get(Zt);e.bindTexture(i.TEXTURE_2D,pt.__webglTexture),xt(i.TEXTURE_2D,Zt),_t(tt.__webglFramebuffer,D,Zt,i.COLOR_ATTACHMENT0+bt,i.TEXTURE_2D,0),m(Zt)&&f(i.TEXTURE_2D)}e.unbindTexture()}else{let bt=i.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(bt=D.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(bt,nt.__webglTexture),xt(bt,w),w.mipmaps&&w.mipmaps.length>0)for(let At=0;At<w.mipmaps.length;At++)_t(tt.__webglFramebuffer[At],D,w,i.COLOR_ATTACHMENT0,bt,At);else _t(tt.__webglFramebuffer,D,w,i.COLOR_ATTACHMENT0,bt,0);m(w)&&f(bt),e.unbindTexture()}D.depthBuffer&&zt(D)}function Jt(D){const w=D.textures;for(let tt=0,nt=w.length;tt<nt;tt++){const Y=w[tt];if(m(Y)){const it=M(D),St=n.get(Y).__webglTexture;e.bindTexture(it,St),f(it),e.unbindTexture()}}}const he=[],G=[];function Ke(D){if(D.samples>0){if(ie(D)===!1){const w=D.textures,tt=D.width,nt=D.height;let Y=i.COLOR_BUFFER_BIT;const it=D.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(D),bt=w.length>1;if(bt)for(let At=0;At<w.length;At++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let At=0;At<w.length;At++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(Y|=i.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(Y|=i.STENCIL_BUFFER_BIT)),bt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[At]);const Zt=n.get(w[At]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,Zt,0)}i.blitFramebuffer(0,0,tt,nt,0,0,tt,nt,Y,i.NEAREST),l===!0&&(he.length=0,G.length=0,he.push(i.COLOR_ATTACHMENT0+At),D.depthBuffer&&D.resolveDepthBuffer===!1&&(he.push(it),G.push(it),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,G)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,he))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),bt)for(let At=0;At<w.length;At++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.RENDERBUFFER,St.__webglColorRenderbuffer[At]);const Zt=n.get(w[At]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+At,i.TEXTURE_2D,Zt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.resolveDepthBuffer===!1&&l){const w=D.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function te(D){return Math.min(s.maxSamples,D.samples)}function ie(D){const w=n.get(D);return D.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Wt(D){const w=r.render.frame;h.get(D)!==w&&(h.set(D,w),D.update())}function me(D,w){const tt=D.colorSpace,nt=D.format,Y=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||tt!==Ko&&tt!==os&&(ve.getTransfer(tt)===Ce?(nt!==li||Y!==Wi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",tt)),w}function Dt(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=O,this.resetTextureUnits=H,this.setTexture2D=$,this.setTexture2DArray=X,this.setTexture3D=j,this.setTextureCube=Q,this.rebindTextures=Ut,this.setupRenderTarget=ce,this.updateRenderTargetMipmap=Jt,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=zt,this.setupFrameBufferTexture=_t,this.useMultisampledRTT=ie}function wI(i,t){function e(n,s=os){let o;const r=ve.getTransfer(s);if(n===Wi)return i.UNSIGNED_BYTE;if(n===Wh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===$h)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Em)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Sm)return i.BYTE;if(n===wm)return i.SHORT;if(n===wr)return i.UNSIGNED_SHORT;if(n===Gh)return i.INT;if(n===qs)return i.UNSIGNED_INT;if(n===Fi)return i.FLOAT;if(n===Er)return i.HALF_FLOAT;if(n===Tm)return i.ALPHA;if(n===Am)return i.RGB;if(n===li)return i.RGBA;if(n===Rm)return i.LUMINANCE;if(n===Cm)return i.LUMINANCE_ALPHA;if(n===Do)return i.DEPTH_COMPONENT;if(n===Go)return i.DEPTH_STENCIL;if(n===Pm)return i.RED;if(n===qh)return i.RED_INTEGER;if(n===Lm)return i.RG;if(n===Xh)return i.RG_INTEGER;if(n===jh)return i.RGBA_INTEGER;if(n===ba||n===ya||n===Ma||n===Sa)if(r===Ce)if(o=t.get("WEBGL_compressed_texture_s3tc_srgb"),o!==null){if(n===ba)return o.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ya)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ma)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Sa)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(o=t.get("WEBGL_compressed_texture_s3tc"),o!==null){if(n===ba)return o.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ya)return o.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ma)return o.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Sa)return o.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Bc||n===zc||n===Hc||n===Vc)if(o=t.get("WEBGL_compressed_texture_pvrtc"),o!==null){if(n===Bc)return o.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===zc)return o.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Hc)return o.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Vc)return o.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Gc||n===Wc||n===$c)if(o=t.get("WEBGL_compressed_texture_etc"),o!==null){if(n===Gc||n===Wc)return r===Ce?o.COMPRESSED_SRGB8_ETC2:o.COMPRESSED_RGB8_ETC2;if(n===$c)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:o.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===qc||n===Xc||n===jc||n===Yc||n===Kc||n===Zc||n===Jc||n===Qc||n===th||n===eh||n===nh||n===ih||n===sh||n===oh)if(o=t.get("WEBGL_compressed_texture_astc"),o!==null){if(n===qc)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:o.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Xc)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:o.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===jc)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:o.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Yc)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:o.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Kc)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:o.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Zc)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:o.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Jc)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:o.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Qc)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:o.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===th)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:o.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===eh)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:o.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===nh)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:o.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ih)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:o.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===sh)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:o.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===oh)return r===Ce?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:o.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===wa||n===rh||n===ah)if(o=t.get("EXT_texture_compression_bptc"),o!==null){if(n===wa)return r===Ce?o.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:o.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===rh)return o.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===ah)return o.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Dm||n===lh||n===ch||n===hh)if(o=t.get("EXT_texture_compression_rgtc"),o!==null){if(n===wa)return o.COMPRESSED_RED_RGTC1_EXT;if(n===lh)return o.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ch)return o.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===hh)return o.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Vo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}class EI extends jn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class bi extends pn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const TI={type:"move"};class sc{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new bi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new bi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new et,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new et),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new bi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new et,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new et),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,o=null,r=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){r=!0;for(const g of t.hand.values()){const m=e.getJointPose(g,n),f=this._getHandJoint(c,g);m!==null&&(f.matrix.fromArray(m.transform.matrix),f.matrix.decompose(f.position,f.rotation,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=m.radius),f.visible=m!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),p=.02,_=.005;c.inputState.pinching&&d>p+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=p-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(o=e.getPose(t.gripSpace,n),o!==null&&(l.matrix.fromArray(o.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,o.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(o.linearVelocity)):l.hasLinearVelocity=!1,o.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(o.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&o!==null&&(s=o),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(TI)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=o!==null),c!==null&&(c.visible=r!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new bi;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}const AI=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,RI=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class CI{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,n){if(this.texture===null){const s=new Tn,o=t.properties.get(s);o.__webglTexture=e.texture,(e.depthNear!=n.depthNear||e.depthFar!=n.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new ps({vertexShader:AI,fragmentShader:RI,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new fn(new Pr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class PI extends Zo{constructor(t,e){super();const n=this;let s=null,o=1,r=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,p=null,_=null;const g=new CI,m=e.getContextAttributes();let f=null,M=null;const S=[],x=[],k=new xe;let P=null;const A=new jn;A.viewport=new $e;const I=new jn;I.viewport=new $e;const E=[A,I],b=new EI;let R=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ot){let ut=S[ot];return ut===void 0&&(ut=new sc,S[ot]=ut),ut.getTargetRaySpace()},this.getControllerGrip=function(ot){let ut=S[ot];return ut===void 0&&(ut=new sc,S[ot]=ut),ut.getGripSpace()},this.getHand=function(ot){let ut=S[ot];return ut===void 0&&(ut=new sc,S[ot]=ut),ut.getHandSpace()};function O(ot){const ut=x.indexOf(ot.inputSource);if(ut===-1)return;const _t=S[ut];_t!==void 0&&(_t.update(ot.inputSource,ot.frame,c||r),_t.dispatchEvent({type:ot.type,data:ot.inputSource}))}function q(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",$);for(let ot=0;ot<S.length;ot++){const ut=x[ot];ut!==null&&(x[ot]=null,S[ot].disconnect(ut))}R=null,H=null,g.reset(),t.setRenderTarget(f),p=null,d=null,u=null,s=null,M=null,mt.stop(),n.isPresenting=!1,t.setPixelRatio(P),t.setSize(k.width,k.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ot){o=ot,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ot){a=ot,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||r},this.setReferenceSpace=function(ot){c=ot},this.getBaseLayer=function(){return d!==null?d:p},this.getBinding=function(){return u},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(ot){if(s=ot,s!==null){if(f=t.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",q),s.addEventListener("inputsourceschange",$),m.xrCompatible!==!0&&await e.makeXRCompatible(),P=t.getPixelRatio(),t.getSize(k),s.renderState.layers===void 0){const ut={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:o};p=new XRWebGLLayer(s,e,ut),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),M=new Xs(p.framebufferWidth,p.framebufferHeight,{format:li,type:Wi,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let ut=null,_t=null,ht=null;m.depth&&(ht=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,ut=m.stencil?Go:Do,_t=m.stencil?Vo:qs);const Nt={colorFormat:e.RGBA8,depthFormat:ht,scaleFactor:o};u=new XRWebGLBinding(s,e),d=u.createProjectionLayer(Nt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),M=new Xs(d.textureWidth,d.textureHeight,{format:li,type:Wi,depthTexture:new Xm(d.textureWidth,d.textureHeight,_t,void 0,void 0,void 0,void 0,void 0,void 0,ut),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,r=await s.requestReferenceSpace(a),mt.setContext(s),mt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function $(ot){for(let ut=0;ut<ot.removed.length;ut++){const _t=ot.removed[ut],ht=x.indexOf(_t);ht>=0&&(x[ht]=null,S[ht].disconnect(_t))}for(let ut=0;ut<ot.added.length;ut++){const _t=ot.added[ut];let ht=x.indexOf(_t);if(ht===-1){for(let zt=0;zt<S.length;zt++)if(zt>=x.length){x.push(_t),ht=zt;break}else if(x[zt]===null){x[zt]=_t,ht=zt;break}if(ht===-1)break}const Nt=S[ht];Nt&&Nt.connect(_t)}}const X=new et,j=new et;function Q(ot,ut,_t){X.setFromMatrixPosition(ut.matrixWorld),j.setFromMatrixPosition(_t.matrixWorld);const ht=X.distanceTo(j),Nt=ut.projectionMatrix.elements,zt=_t.projectionMatrix.elements,Ut=Nt[14]/(Nt[10]-1),ce=Nt[14]/(Nt[10]+1),Jt=(Nt[9]+1)/Nt[5],he=(Nt[9]-1)/Nt[5],G=(Nt[8]-1)/Nt[0],Ke=(zt[8]+1)/zt[0],te=Ut*G,ie=Ut*Ke,Wt=ht/(-G+Ke),me=Wt*-G;if(ut.matrixWorld.decompose(ot.position,ot.quaternion,ot.scale),ot.translateX(me),ot.translateZ(Wt),ot.matrixWorld.compose(ot.position,ot.quaternion,ot.scale),ot.matrixWorldInverse.copy(ot.matrixWorld).invert(),Nt[10]===-1)ot.projectionMatrix.copy(ut.projectionMatrix),ot.projectionMatrixInverse.copy(ut.projectionMatrixInverse);else{const Dt=Ut+Wt,D=ce+Wt,w=te-me,tt=ie+(ht-me),nt=Jt*ce/D*Dt,Y=he*ce/D*Dt;ot.projectionMatrix.makePerspective(w,tt,nt,Y,Dt,D),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert()}}function at(ot,ut){ut===null?ot.matrixWorld.copy(ot.matrix):ot.matrixWorld.multiplyMatrices(ut.matrixWorld,ot.matrix),ot.matrixWorldInverse.copy(ot.matrixWorld).invert()}this.updateCamera=function(ot){if(s===null)return;let ut=ot.near,_t=ot.far;g.texture!==null&&(g.depthNear>0&&(ut=g.depthNear),g.depthFar>0&&(_t=g.depthFar)),b.near=I.near=A.near=ut,b.far=I.far=A.far=_t,(R!==b.near||H!==b.far)&&(s.updateRenderState({depthNear:b.near,depthFar:b.far}),R=b.near,H=b.far),A.layers.mask=ot.layers.mask|2,I.layers.mask=ot.layers.mask|4,b.layers.mask=A.layers.mask|I.layers.mask;const ht=ot.parent,Nt=b.cameras;at(b,ht);for(let zt=0;zt<Nt.length;zt++)at(Nt[zt],ht);Nt.length===2?Q(b,A,I):b.projectionMatrix.copy(A.projectionMatrix),lt(ot,b,ht)};function lt(ot,ut,_t){_t===null?ot.matrix.copy(ut.matrixWorld):(ot.matrix.copy(_t.matrixWorld),ot.matrix.invert(),ot.matrix.multiply(ut.matrixWorld)),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.updateMatrixWorld(!0),ot.projectionMatrix.copy(ut.projectionMatrix),ot.projectionMatrixInverse.copy(ut.projectionMatrixInverse),ot.isPerspectiveCamera&&(ot.fov=uh*2*Math.atan(1/ot.projectionMatrix.elements[5]),ot.zoom=1)}this.getCamera=function(){return b},this.getFoveation=function(){if(!(d===null&&p===null))return l},this.setFoveation=function(ot){l=ot,d!==null&&(d.fixedFoveation=ot),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ot)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(b)};let gt=null;function xt(ot,ut){if(h=ut.getViewerPose(c||r),_=ut,h!==null){const _t=h.views;p!==null&&(t.setRenderTargetFramebuffer(M,p.framebuffer),t.setRenderTarget(M));let ht=!1;_t.length!==b.cameras.length&&(b.cameras.length=0,ht=!0);for(let zt=0;zt<_t.length;zt++){const Ut=_t[zt];let ce=null;if(p!==null)ce=p.getViewport(Ut);else{const he=u.getViewSubImage(d,Ut);ce=he.viewport,zt===0&&(t.setRenderTargetTextures(M,he.colorTexture,d.ignoreDepthValues?void 0:he.depthStencilTexture),t.setRenderTarget(M))}let Jt=E[zt];Jt===void 0&&(Jt=new jn,Jt.layers.enable(zt),Jt.viewport=new $e,E[zt]=Jt),Jt.matrix.fromArray(Ut.transform.matrix),Jt.matrix.decompose(Jt.position,Jt.quaternion,Jt.scale),Jt.projectionMatrix.fromArray(Ut.projectionMatrix),Jt.projectionMatrixInverse.copy(Jt.projectionMatrix).invert(),Jt.viewport.set(ce.x,ce.y,ce.width,ce.height),zt===0&&(b.matrix.copy(Jt.matrix),b.matrix.decompose(b.position,b.quaternion,b.scale)),ht===!0&&b.cameras.push(Jt)}const Nt=s.enabledFeatures;if(Nt&&Nt.includes("depth-sensing")){const zt=u.getDepthInformation(_t[0]);zt&&zt.isValid&&zt.texture&&g.init(t,zt,s.renderState)}}for(let _t=0;_t<S.length;_t++){const ht=x[_t],Nt=S[_t];ht!==null&&Nt!==void 0&&Nt.update(ht,ut,c||r)}gt&&gt(ot,ut),ut.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ut}),_=null}const mt=new $m;mt.setAnimationLoop(xt),this.setAnimationLoop=function(ot){gt=ot},this.dispose=function(){}}}const Rs=new wi,LI=new Ve;function DI(i,t){function e(m,f){m.matrixAutoUpdate===!0&&m.updateMatrix(),f.value.copy(m.matrix)}function n(m,f){f.color.getRGB(m.fogColor.value,Vm(i)),f.isFog?(m.fogNear.value=f.near,m.fogFar.value=f.far):f.isFogExp2&&(m.fogDensity.value=f.density)}function s(m,f,M,S,x){f.isMeshBasicMaterial||f.isMeshLambertMaterial?o(m,f):f.isMeshToonMaterial?(o(m,f),u(m,f)):f.isMeshPhongMaterial?(o(m,f),h(m,f)):f.isMeshStandardMaterial?(o(m,f),d(m,f),f.isMeshPhysicalMaterial&&p(m,f,x)):f.isMeshMatcapMaterial?(o(m,f),_(m,f)):f.isMeshDepthMaterial?o(m,f):f.isMeshDistanceMaterial?(o(m,f),g(m,f)):f.isMeshNormalMaterial?o(m,f):f.isLineBasicMaterial?(r(m,f),f.isLineDashedMaterial&&a(m,f)):f.isPointsMaterial?l(m,f,M,S):f.isSpriteMaterial?c(m,f):f.isShadowMaterial?(m.color.value.copy(f.color),m.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function o(m,f){m.opacity.value=f.opacity,f.color&&m.diffuse.value.copy(f.color),f.emissive&&m.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(m.map.value=f.map,e(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.bumpMap&&(m.bumpMap.value=f.bumpMap,e(f.bumpMap,m.bumpMapTransform),m.bumpScale.value=f.bumpScale,f.side===Ln&&(m.bumpScale.value*=-1)),f.normalMap&&(m.normalMap.value=f.normalMap,e(f.normalMap,m.normalMapTransform),m.normalScale.value.copy(f.normalScale),f.side===Ln&&m.normalScale.value.negate()),f.displacementMap&&(m.displacementMap.value=f.displacementMap,e(f.displacementMap,m.displacementMapTransform),m.displacementScale.value=f.displacementScale,m.displacementBias.value=f.displacementBias),f.emissiveMap&&(m.emissiveMap.value=f.emissiveMap,e(f.emissiveMap,m.emissiveMapTransform)),f.specularMap&&(m.specularMap.value=f.specularMap,e(f.specularMap,m.specularMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest);const M=t.get(f),S=M.envMap,x=M.envMapRotation;S&&(m.envMap.value=S,Rs.copy(x),Rs.x*=-1,Rs.y*=-1,Rs.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(Rs.y*=-1,Rs.z*=-1),m.envMapRotation.value.setFromMatrix4(LI.makeRotationFromEuler(Rs)),m.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=f.reflectivity,m.ior.value=f.ior,m.refractionRatio.value=f.refractionRatio),f.lightMap&&(m.lightMap.value=f.lightMap,m.lightMapIntensity.value=f.lightMapIntensity,e(f.lightMap,m.lightMapTransform)),f.aoMap&&(m.aoMap.value=f.aoMap,m.aoMapIntensity.value=f.aoMapIntensity,e(f.aoMap,m.aoMapTransform))}function r(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,f.map&&(m.map.value=f.map,e(f.map,m.mapTransform))}function a(m,f){m.dashSize.value=f.dashSize,m.totalSize.value=f.dashSize+f.gapSize,m.scale.value=f.scale}function l(m,f,M,S){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.size.value=f.size*M,m.scale.value=S*.5,f.map&&(m.map.value=f.map,e(f.map,m.uvTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function c(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.rotation.value=f.rotation,f.map&&(m.map.value=f.map,e(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function h(m,f){m.specular.value.copy(f.specular),m.shininess.value=Math.max(f.shininess,1e-4)}function u(m,f){f.gradientMap&&(m.gradientMap.value=f.gradientMap)}function d(m,f){m.metalness.value=f.metalness,f.metalnessMap&&(m.metalnessMap.value=f.metalnessMap,e(f.metalnessMap,m.metalnessMapTransform)),m.roughness.value=f.roughness,f.roughnessMap&&(m.roughnessMap.value=f.roughnessMap,e(f.roughnessMap,m.roughnessMapTransform)),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)}function p(m,f,M){m.ior.value=f.ior,f.sheen>0&&(m.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),m.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(m.sheenColorMap.value=f.sheenColorMap,e(f.sheenColorMap,m.sheenColorMapTransform)),f.sheenRoughnessMap&&(m.sheenRoughnessMap.value=f.sheenRoughnessMap,e(f.sheenRoughnessMap,m.sheenRoughnessMapTransform))),f.clearcoat>0&&(m.clearcoat.value=f.clearcoat,m.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(m.clearcoatMap.value=f.clearcoatMap,e(f.clearcoatMap,m.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,e(f.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(m.clearcoatNormalMap.value=f.clearcoatNormalMap,e(f.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===Ln&&m.clearcoatNormalScale.value.negate())),f.dispersion>0&&(m.dispersion.value=f.dispersion),f.iridescence>0&&(m.iridescence.value=f.iridescence,m.iridescenceIOR.value=f.iridescenceIOR,m.iridescenceThicknessMinimum.value=f.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=f.iridescenceThicknessRange[1],f.iridescenceMap&&(m.iridescenceMap.value=f.iridescenceMap,e(f.iridescenceMap,m.iridescenceMapTransform)),f.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=f.iridescenceThicknessMap,e(f.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),f.transmission>0&&(m.transmission.value=f.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),f.transmissionMap&&(m.transmissionMap.value=f.transmissionMap,e(f.transmissionMap,m.transmissionMapTransform)),m.thickness.value=f.thickness,f.thicknessMap&&(m.thicknessMap.value=f.thicknessMap,e(f.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=f.attenuationDistance,m.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(m.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(m.anisotropyMap.value=f.anisotropyMap,e(f.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=f.specularIntensity,m.specularColor.value.copy(f.specularColor),f.specularColorMap&&(m.specularColorMap.value=f.specularColorMap,e(f.specularColorMap,m.specularColorMapTransform)),f.specularIntensityMap&&(m.specularIntensityMap.value=f.specularIntensityMap,e(f.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,f){f.matcap&&(m.matcap.value=f.matcap)}function g(m,f){const M=t.get(f).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function II(i,t,e,n){let s={},o={},r=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(M,S){const x=S.program;n.uniformBlockBinding(M,x)}function c(M,S){let x=s[M.id];x===void 0&&(_(M),x=h(M),s[M.id]=x,M.addEventListener("dispose",m));const k=S.program;n.updateUBOMapping(M,k);const P=t.render.frame;o[M.id]!==P&&(d(M),o[M.id]=P)}function h(M){const S=u();M.__bindingPointIndex=S;const x=i.createBuffer(),k=M.__size,P=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,x),i.bufferData(i.UNIFORM_BUFFER,k,P),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,S,x),x}function u(){for(let M=0;M<a;M++)if(r.indexOf(M)===-1)return r.push(M),M;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(M){const S=s[M.id],x=M.uniforms,k=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let P=0,A=x.length;P<A;P++){const I=Array.isArray(x[P])?x[P]:[x[P]];for(let E=0,b=I.length;E<b;E++){const R=I[E];if(p(R,P,E,k)===!0){const H=R.__offset,O=Array.isArray(R.value)?R.value:[R.value];let q=0;for(let $=0;$<O.length;$++){const X=O[$],j=g(X);typeof X=="number"||typeof X=="boolean"?(R.__data[0]=X,i.bufferSubData(i.UNIFORM_BUFFER,H+q,R.__data)):X.isMatrix3?(R.__data[0]=X.elements[0],R.__data[1]=X.elements[1],R.__data[2]=X.elements[2],R.__data[3]=0,R.__data[4]=X.elements[3],R.__data[5]=X.elements[4],R.__data[6]=X.elements[5],R.__data[7]=0,R.__data[8]=X.elements[6],R.__data[9]=X.elements[7],R.__data[10]=X.elements[8],R.__data[11]=0):(X.toArray(R.__data,q),q+=j.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,H,R.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function p(M,S,x,k){const P=M.value,A=S+"_"+x;if(k[A]===void 0)return typeof P=="number"||typeof P=="boolean"?k[A]=P:k[A]=P.clone(),!0;{const I=k[A];if(typeof P=="number"||typeof P=="boolean"){if(I!==P)return k[A]=P,!0}else if(I.equals(P)===!1)return I.copy(P),!0}return!1}function _(M){const S=M.uniforms;let x=0;const k=16;for(let A=0,I=S.length;A<I;A++){const E=Array.isArray(S[A])?S[A]:[S[A]];for(let b=0,R=E.length;b<R;b++){const H=E[b],O=Array.isArray(H.value)?H.value:[H.value];for(let q=0,$=O.length;q<$;q++){const X=O[q],j=g(X),Q=x%k,at=Q%j.boundary,lt=Q+at;x+=at,lt!==0&&k-lt<j.storage&&(x+=k-lt),H.__data=new Float32Array(j.storage/Float32Array.BYTES_PER_ELEMENT),H.__offset=x,x+=j.storage}}}const P=x%k;return P>0&&(x+=k-P),M.__size=x,M.__cache={},this}function g(M){const S={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(S.boundary=4,S.storage=4):M.isVector2?(S.boundary=8,S.storage=8):M.isVector3||M.isColor?(S.boundary=16,S.storage=12):M.isVector4?(S.boundary=16,S.storage=16):M.isMatrix3?(S.boundary=48,S.storage=48):M.isMatrix4?(S.boundary=64,S.storage=64):M.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",M),S}function m(M){const S=M.target;S.removeEventListener("dispose",m);const x=r.indexOf(S.__bindingPointIndex);r.splice(x,1),i.deleteBuffer(s[S.id]),delete s[S.id],delete o[S.id]}function f(){for(const M in s)i.deleteBuffer(s[M]);r=[],s={},o={}}return{bind:l,update:c,dispose:f}}class NI{constructor(t={}){const{canvas:e=MC(),context:n=null,depth:s=!0,stencil:o=!1,alpha:r=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reverseDepthBuffer:d=!1}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=r;const _=new Uint32Array(4),g=new Int32Array(4);let m=null,f=null;const M=[],S=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=Bn,this.toneMapping=ls,this.toneMappingExposure=1;const x=this;let k=!1,P=0,A=0,I=null,E=-1,b=null;const R=new $e,H=new $e;let O=null;const q=new pe(0);let $=0,X=e.width,j=e.height,Q=1,at=null,lt=null;const gt=new $e(0,0,X,j),xt=new $e(0,0,X,j);let mt=!1;const ot=new Jh;let ut=!1,_t=!1;const ht=new Ve,Nt=new Ve,zt=new et,Ut=new $e,ce={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Jt=!1;function he(){return I===null?Q:1}let G=n;function Ke(T,z){return e.getContext(T,z)}try{const T={alpha:!0,depth:s,stencil:o,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Vh}`),e.addEventListener("webglcontextlost",ct,!1),e.addEventListener("webglcontextrestored",Rt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),G===null){const z="webgl2";if(G=Ke(z,T),G===null)throw Ke(z)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(T){throw console.error("THREE.WebGLRenderer: "+T.message),T}let te,ie,Wt,me,Dt,D,w,tt,nt,Y,it,St,bt,At,Zt,pt,yt,Ot,Ht,Et,oe,Yt,ge,V;function Mt(){te=new BL(G),te.init(),Yt=new wI(G,te),ie=new IL(G,te,t,Yt),Wt=new yI(G,te),ie.reverseDepthBuffer&&d&&Wt.buffers.depth.setReversed(!0),me=new VL(G),Dt=new rI,D=new SI(G,te,Wt,Dt,ie,Yt,me),w=new UL(x),tt=new OL(x),nt=new YC(G),ge=new LL(G,nt),Y=new zL(G,nt,me,ge),it=new WL(G,Y,nt,me),Ht=new GL(G,ie,D),pt=new NL(Dt),St=new oI(x,w,tt,te,ie,ge,pt),bt=new DI(x,Dt),At=new lI,Zt=new pI(te),Ot=new PL(x,w,tt,Wt,it,p,l),yt=new xI(x,it,ie),V=new II(G,me,ie,Wt),Et=new DL(G,te,me),oe=new HL(G,te,me),me.programs=St.programs,x.capabilities=ie,x.extensions=te,x.properties=Dt,x.renderLists=At,x.shadowMap=yt,x.state=Wt,x.info=me}Mt();const st=new PI(x,G);this.xr=st,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){const T=te.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){const T=te.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(T){T!==void 0&&(Q=T,this.setSize(X,j,!1))},this.getSize=function(T){return T.set(X,j)},this.setSize=function(T,z,K=!0){if(st.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}X=T,j=z,e.width=Math.floor(T*Q),e.height=Math.floor(z*Q),K===!0&&(e.style.width=T+"px",e.style.height=z+"px"),this.setViewport(0,0,T,z)},this.getDrawingBufferSize=function(T){return T.set(X*Q,j*Q).floor()},this.setDrawingBufferSize=function(T,z,K){X=T,j=z,Q=K,e.width=Math.floor(T*K),e.height=Math.floor(z*K),this.setViewport(0,0,T,z)},this.getCurrentViewport=function(T){return T.copy(R)},this.getViewport=function(T){return T.copy(gt)},this.setViewport=function(T,z,K,Z){T.isVector4?gt.set(T.x,T.y,T.z,T.w):gt.set(T,z,K,Z),Wt.viewport(R.copy(gt).multiplyScalar(Q).round())},this.getScissor=function(T){return T.copy(xt)},this.setScissor=function(T,z,K,Z){T.isVector4?xt.set(T.x,T.y,T.z,T.w):xt.set(T,z,K,Z),Wt.scissor(H.copy(xt).multiplyScalar(Q).round())},this.getScissorTest=function(){return mt},this.setScissorTest=function(T){Wt.setScissorTest(mt=T)},this.setOpaqueSort=function(T){at=T},this.setTransparentSort=function(T){lt=T},this.getClearColor=function(T){return T.copy(Ot.getClearColor())},this.setClearColor=function(){Ot.setClearColor.apply(Ot,arguments)},this.getClearAlpha=function(){return Ot.getClearAlpha()},this.setClearAlpha=function(){Ot.setClearAlpha.apply(Ot,arguments)},this.clear=function(T=!0,z=!0,K=!0){let Z=0;if(T){let W=!1;if(I!==null){const ft=I.texture.format;W=ft===jh||ft===Xh||ft===qh}if(W){const ft=I.texture.type,wt=ft===Wi||ft===qs||ft===wr||ft===Vo||ft===Wh||ft===$h,Bt=Ot.getClearColor(),kt=Ot.getClearAlpha(),$t=Bt.r,Xt=Bt.g,Ft=Bt.b;wt?(_[0]=$t,_[1]=Xt,_[2]=Ft,_[3]=kt,G.clearBufferuiv(G.COLOR,0,_)):(g[0]=$t,g[1]=Xt,g[2]=Ft,g[3]=kt,G.clearBufferiv(G.COLOR,0,g))}else Z|=G.COLOR_BUFFER_BIT}z&&(Z|=G.DEPTH_BUFFER_BIT),K&&(Z|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),G.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",ct,!1),e.removeEventListener("webglcontextrestored",Rt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),At.dispose(),Zt.dispose(),Dt.dispose(),w.dispose(),tt.dispose(),it.dispose(),ge.dispose(),V.dispose(),St.dispose(),st.dispose(),st.removeEventListener("sessionstart",Dn),st.removeEventListener("sessionend",Ei),An.stop()};function ct(T){T.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),k=!0}function Rt(){console.log("THREE.WebGLRenderer: Context Restored."),k=!1;const T=me.autoReset,z=yt.enabled,K=yt.autoUpdate,Z=yt.needsUpdate,W=yt.type;Mt(),me.autoReset=T,yt.enabled=z,yt.autoUpdate=K,yt.needsUpdate=Z,yt.type=W}function Ct(T){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function Qt(T){const z=T.target;z.removeEventListener("dispose",Qt),Oe(z)}function Oe(T){sn(T),Dt.remove(T)}function sn(T){const z=Dt.get(T).programs;z!==void 0&&(z.forEach(function(K){St.releaseProgram(K)}),T.isShaderMaterial&&St.releaseShaderCache(T))}this.renderBufferDirect=function(T,z,K,Z,W,ft){z===null&&(z=ce);const wt=W.isMesh&&W.matrixWorld.determinant()<0,Bt=il(T,z,K,Z,W);Wt.setMaterial(Z,wt);let kt=K.index,$t=1;if(Z.wireframe===!0){if(kt=Y.getWireframeAttribute(K),kt===void 0)return;$t=2}const Xt=K.drawRange,Ft=K.attributes.position;let ae=Xt.start*$t,Ee=(Xt.start+Xt.count)*$t;ft!==null&&(ae=Math.max(ae,ft.start*$t),Ee=Math.min(Ee,(ft.start+ft.count)*$t)),kt!==null?(ae=Math.max(ae,0),Ee=Math.min(Ee,kt.count)):Ft!=null&&(ae=Math.max(ae,0),Ee=Math.min(Ee,Ft.count));const Ae=Ee-ae;if(Ae<0||Ae===1/0)return;ge.setup(W,Z,Bt,K,kt);let on,ue=Et;if(kt!==null&&(on=nt.get(kt),ue=oe,ue.setIndex(on)),W.isMesh)Z.wireframe===!0?(Wt.setLineWidth(Z.wireframeLinewidth*he()),ue.setMode(G.LINES)):ue.setMode(G.TRIANGLES);else if(W.isLine){let Vt=Z.linewidth;Vt===void 0&&(Vt=1),Wt.setLineWidth(Vt*he()),W.isLineSegments?ue.setMode(G.LINES):W.isLineLoop?ue.setMode(G.LINE_LOOP):ue.setMode(G.LINE_STRIP)}else W.isPoints?ue.setMode(G.POINTS):W.isSprite&&ue.setMode(G.TRIANGLES);if(W.isBatchedMesh)if(W._multiDrawInstances!==null)ue.renderMultiDrawInstances(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount,W._multiDrawInstances);else if(te.get("WEBGL_multi_draw"))ue.renderMultiDraw(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount);else{const Vt=W._multiDrawStarts,Be=W._multiDrawCounts,_e=W._multiDrawCount,Rn=kt?nt.get(kt).bytesPerElement:1,ui=Dt.get(Z).currentProgram.getUniforms();for(let gn=0;gn<_e;gn++)ui.setValue(G,"_gl_DrawID",gn),ue.render(Vt[gn]/Rn,Be[gn])}else if(W.isInstancedMesh)ue.renderInstances(ae,Ae,W.count);else if(K.isInstancedBufferGeometry){const Vt=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Be=Math.min(K.instanceCount,Vt);ue.renderInstances(ae,Ae,Be)}else ue.render(ae,Ae)};function Me(T,z,K){T.transparent===!0&&T.side===ki&&T.forceSinglePass===!1?(T.side=Ln,T.needsUpdate=!0,Zs(T,z,K),T.side=fs,T.needsUpdate=!0,Zs(T,z,K),T.side=ki):Zs(T,z,K)}this.compile=function(T,z,K=null){K===null&&(K=T),f=Zt.get(K),f.init(z),S.push(f),K.traverseVisible(function(W){W.isLight&&W.layers.test(z.layers)&&(f.pushLight(W),W.castShadow&&f.pushShadow(W))}),T!==K&&T.traverseVisible(function(W){W.isLight&&W.layers.test(z.layers)&&(f.pushLight(W),W.castShadow&&f.pushShadow(W))}),f.setupLights();const Z=new Set;return T.traverse(function(W){if(!(W.isMesh||W.isPoints||W.isLine||W.isSprite))return;const ft=W.material;if(ft)if(Array.isArray(ft))for(let wt=0;wt<ft.length;wt++){const Bt=ft[wt];Me(Bt,K,W),Z.add(Bt)}else Me(ft,K,W),Z.add(ft)}),S.pop(),f=null,Z},this.compileAsync=function(T,z,K=null){const Z=this.compile(T,z,K);return new Promise(W=>{function ft(){if(Z.forEach(function(wt){Dt.get(wt).currentProgram.isReady()&&Z.delete(wt)}),Z.size===0){W(T);return}setTimeout(ft,10)}te.get("KHR_parallel_shader_compile")!==null?ft():setTimeout(ft,10)})};let Ze=null;function Ie(T){Ze&&Ze(T)}function Dn(){An.stop()}function Ei(){An.start()}const An=new $m;An.setAnimationLoop(Ie),typeof self<"u"&&An.setContext(self),this.setAnimationLoop=function(T){Ze=T,st.setAnimationLoop(T),T===null?An.stop():An.start()},st.addEventListener("sessionstart",Dn),st.addEventListener("sessionend",Ei),this.render=function(T,z){if(z!==void 0&&z.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(k===!0)return;if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),st.enabled===!0&&st.isPresenting===!0&&(st.cameraAutoUpdate===!0&&st.updateCamera(z),z=st.getCamera()),T.isScene===!0&&T.onBeforeRender(x,T,z,I),f=Zt.get(T,S.length),f.init(z),S.push(f),Nt.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),ot.setFromProjectionMatrix(Nt),_t=this.localClippingEnabled,ut=pt.init(this.clippingPlanes,_t),m=At.get(T,M.length),m.init(),M.push(m),st.enabled===!0&&st.isPresenting===!0){const ft=x.xr.getDepthSensingMesh();ft!==null&&mn(ft,z,-1/0,x.sortObjects)}mn(T,z,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(at,lt),Jt=st.enabled===!1||st.isPresenting===!1||st.hasDepthSensing()===!1,Jt&&Ot.addToRenderList(m,T),this.info.render.frame++,ut===!0&&pt.beginShadows();const K=f.state.shadowsArray;yt.render(K,T,z),ut===!0&&pt.endShadows(),this.info.autoReset===!0&&this.info.reset();const Z=m.opaque,W=m.transmissive;if(f.setupLights(),z.isArrayCamera){const ft=z.cameras;if(W.length>0)for(let wt=0,Bt=ft.length;wt<Bt;wt++){const kt=ft[wt];Ai(Z,W,T,kt)}Jt&&Ot.render(T);for(let wt=0,Bt=ft.length;wt<Bt;wt++){const kt=ft[wt];Ti(m,T,kt,kt.viewport)}}else W.length>0&&Ai(Z,W,T,z),Jt&&Ot.render(T),Ti(m,T,z);I!==null&&(D.updateMultisampleRenderTarget(I),D.updateRenderTargetMipmap(I)),T.isScene===!0&&T.onAfterRender(x,T,z),ge.resetDefaultState(),E=-1,b=null,S.pop(),S.length>0?(f=S[S.length-1],ut===!0&&pt.setGlobalState(x.clippingPlanes,f.state.camera)):f=null,M.pop(),M.length>0?m=M[M.length-1]:m=null};function mn(T,z,K,Z){if(T.visible===!1)return;if(T.layers.test(z.layers)){if(T.isGroup)K=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(z);else if(T.isLight)f.pushLight(T),T.castShadow&&f.pushShadow(T);else if(T.isSprite){if(!T.frustumCulled||ot.intersectsSprite(T)){Z&&Ut.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Nt);const wt=it.update(T),Bt=T.material;Bt.visible&&m.push(T,wt,Bt,K,Ut.z,null)}}else if((T.isMesh||T.isLine||T.isPoints)&&(!T.frustumCulled||ot.intersectsObject(T))){const wt=it.update(T),Bt=T.material;if(Z&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),Ut.copy(T.boundingSphere.center)):(wt.boundingSphere===null&&wt.computeBoundingSphere(),Ut.copy(wt.boundingSphere.center)),Ut.applyMatrix4(T.matrixWorld).applyMatrix4(Nt)),Array.isArray(Bt)){const kt=wt.groups;for(let $t=0,Xt=kt.length;$t<Xt;$t++){const Ft=kt[$t],ae=Bt[Ft.materialIndex];ae&&ae.visible&&m.push(T,wt,ae,K,Ut.z,Ft)}}else Bt.visible&&m.push(T,wt,Bt,K,Ut.z,null)}}const ft=T.children;for(let wt=0,Bt=ft.length;wt<Bt;wt++)mn(ft[wt],z,K,Z)}function Ti(T,z,K,Z){const W=T.opaque,ft=T.transmissive,wt=T.transparent;f.setupLightsView(K),ut===!0&&pt.setGlobalState(x.clippingPlanes,K),Z&&Wt.viewport(R.copy(Z)),W.length>0&&gs(W,z,K),ft.length>0&&gs(ft,z,K),wt.length>0&&gs(wt,z,K),Wt.buffers.depth.setTest(!0),Wt.buffers.depth.setMask(!0),Wt.buffers.color.setMask(!0),Wt.setPolygonOffset(!1)}function Ai(T,z,K,Z){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;f.state.transmissionRenderTarget[Z.id]===void 0&&(f.state.transmissionRenderTarget[Z.id]=new Xs(1,1,{generateMipmaps:!0,type:te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float")?Er:Wi,minFilter:Os,samples:4,stencilBuffer:o,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ve.workingColorSpace}));const ft=f.state.transmissionRenderTarget[Z.id],wt=Z.viewport||R;ft.setSize(wt.z,wt.w);const Bt=x.getRenderTarget();x.setRenderTarget(ft),x.getClearColor(q),$=x.getClearAlpha(),$<1&&x.setClearColor(16777215,.5),x.clear(),Jt&&Ot.render(K);const kt=x.toneMapping;x.toneMapping=ls;const $t=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),f.setupLightsView(Z),ut===!0&&pt.setGlobalState(x.clippingPlanes,Z),gs(T,K,Z),D.updateMultisampleRenderTarget(ft),D.updateRenderTargetMipmap(ft),te.has("WEBGL_multisampled_render_to_texture")===!1){let Xt=!1;for(let Ft=0,ae=z.length;Ft<ae;Ft++){const Ee=z[Ft],Ae=Ee.object,on=Ee.geometry,ue=Ee.material,Vt=Ee.group;if(ue.side===ki&&Ae.layers.test(Z.layers)){const Be=ue.side;ue.side=Ln,ue.needsUpdate=!0,tr(Ae,K,Z,on,ue,Vt),ue.side=Be,ue.needsUpdate=!0,Xt=!0}}Xt===!0&&(D.updateMultisampleRenderTarget(ft),D.updateRenderTargetMipmap(ft))}x.setRenderTarget(Bt),x.setClearColor(q,$),$t!==void 0&&(Z.viewport=$t),x.toneMapping=kt}function gs(T,z,K){const Z=z.isScene===!0?z.overrideMaterial:null;for(let W=0,ft=T.length;W<ft;W++){const wt=T[W],Bt=wt.object,kt=wt.geometry,$t=Z===null?wt.material:Z,Xt=wt.group;Bt.layers.test(K.layers)&&tr(Bt,z,K,kt,$t,Xt)}}function tr(T,z,K,Z,W,ft){T.onBeforeRender(x,z,K,Z,W,ft),T.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),W.onBeforeRender(x,z,K,Z,T,ft),W.transparent===!0&&W.side===ki&&W.forceSinglePass===!1?(W.side=Ln,W.needsUpdate=!0,x.renderBufferDirect(K,z,Z,W,T,ft),W.side=fs,W.needsUpdate=!0,x.renderBufferDirect(K,z,Z,W,T,ft),W.side=ki):x.renderBufferDirect(K,z,Z,W,T,ft),T.onAfterRender(x,z,K,Z,W,ft)}function Zs(T,z,K){z.isScene!==!0&&(z=ce);const Z=Dt.get(T),W=f.state.lights,ft=f.state.shadowsArray,wt=W.state.version,Bt=St.getParameters(T,W.state,ft,z,K),kt=St.getProgramCacheKey(Bt);let $t=Z.programs;Z.environment=T.isMeshStandardMaterial?z.environment:null,Z.fog=z.fog,Z.envMap=(T.isMeshStandardMaterial?tt:w).get(T.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&T.envMap===null?z.environmentRotation:T.envMapRotation,$t===void 0&&(T.addEventListener("dispose",Qt),$t=new Map,Z.programs=$t);let Xt=$t.get(kt);if(Xt!==void 0){if(Z.currentProgram===Xt&&Z.lightsStateVersion===wt)return hi(T,Bt),Xt}else Bt.uniforms=St.getUniforms(T),T.onBeforeCompile(Bt,x),Xt=St.acquireProgram(Bt,kt),$t.set(kt,Xt),Z.uniforms=Bt.uniforms;const Ft=Z.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Ft.clippingPlanes=pt.uniform),hi(T,Bt),Z.needsLights=Dr(T),Z.lightsStateVersion=wt,Z.needsLights&&(Ft.ambientLightColor.value=W.state.ambient,Ft.lightProbe.value=W.state.probe,Ft.directionalLights.value=W.state.directional,Ft.directionalLightShadows.value=W.state.directionalShadow,Ft.spotLights.value=W.state.spot,Ft.spotLightShadows.value=W.state.spotShadow,Ft.rectAreaLights.value=W.state.rectArea,Ft.ltc_1.value=W.state.rectAreaLTC1,Ft.ltc_2.value=W.state.rectAreaLTC2,Ft.pointLights.value=W.state.point,Ft.pointLightShadows.value=W.state.pointShadow,Ft.hemisphereLights.value=W.state.hemi,Ft.directionalShadowMap.value=W.state.directionalShadowMap,Ft.directionalShadowMatrix.value=W.state.directionalShadowMatrix,Ft.spotShadowMap.value=W.state.spotShadowMap,Ft.spotLightMatrix.value=W.state.spotLightMatrix,Ft.spotLightMap.value=W.state.spotLightMap,Ft.pointShadowMap.value=W.state.pointShadowMap,Ft.pointShadowMatrix.value=W.state.pointShadowMatrix),Z.currentProgram=Xt,Z.uniformsList=null,Xt}function Lr(T){if(T.uniformsList===null){const z=T.currentProgram.getUniforms();T.uniformsList=Ea.seqWithValue(z.seq,T.uniforms)}return T.uniformsList}function hi(T,z){const K=Dt.get(T);K.outputColorSpace=z.outputColorSpace,K.batching=z.batching,K.batchingColor=z.batchingColor,K.instancing=z.instancing,K.instancingColor=z.instancingColor,K.instancingMorph=z.instancingMorph,K.skinning=z.skinning,K.morphTargets=z.morphTargets,K.morphNormals=z.morphNormals,K.morphColors=z.morphColors,K.morphTargetsCount=z.morphTargetsCount,K.numClippingPlanes=z.numClippingPlanes,K.numIntersection=z.numClipIntersection,K.vertexAlphas=z.vertexAlphas,K.vertexTangents=z.vertexTangents,K.toneMapping=z.toneMapping}function il(T,z,K,Z,W){z.isScene!==!0&&(z=ce),D.resetTextureUnits();const ft=z.fog,wt=Z.isMeshStandardMaterial?z.environment:null,Bt=I===null?x.outputColorSpace:I.isXRRenderTarget===!0?I.texture.colorSpace:Ko,kt=(Z.isMeshStandardMaterial?tt:w).get(Z.envMap||wt),$t=Z.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,Xt=!!K.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ft=!!K.morphAttributes.position,ae=!!K.morphAttributes.normal,Ee=!!K.morphAttributes.color;let Ae=ls;Z.toneMapped&&(I===null||I.isXRRenderTarget===!0)&&(Ae=x.toneMapping);const on=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,ue=on!==void 0?on.length:0,Vt=Dt.get(Z),Be=f.state.lights;if(ut===!0&&(_t===!0||T!==b)){const bn=T===b&&Z.id===E;pt.setState(Z,T,bn)}let _e=!1;Z.version===Vt.__version?(Vt.needsLights&&Vt.lightsStateVersion!==Be.state.version||Vt.outputColorSpace!==Bt||W.isBatchedMesh&&Vt.batching===!1||!W.isBatchedMesh&&Vt.batching===!0||W.isBatchedMesh&&Vt.batchingColor===!0&&W.colorTexture===null||W.isBatchedMesh&&Vt.batchingColor===!1&&W.colorTexture!==null||W.isInstancedMesh&&Vt.instancing===!1||!W.isInstancedMesh&&Vt.instancing===!0||W.isSkinnedMesh&&Vt.skinning===!1||!W.isSkinnedMesh&&Vt.skinning===!0||W.isInstancedMesh&&Vt.instancingColor===!0&&W.instanceColor===null||W.isInstancedMesh&&Vt.instancingColor===!1&&W.instanceColor!==null||W.isInstancedMesh&&Vt.instancingMorph===!0&&W.morphTexture===null||W.isInstancedMesh&&Vt.instancingMorph===!1&&W.morphTexture!==null||Vt.envMap!==kt||Z.fog===!0&&Vt.fog!==ft||Vt.numClippingPlanes!==void 0&&(Vt.numClippingPlanes!==pt.numPlanes||Vt.numIntersection!==pt.numIntersection)||Vt.vertexAlphas!==$t||Vt.vertexTangents!==Xt||Vt.morphTargets!==Ft||Vt.morphNormals!==ae||Vt.morphColors!==Ee||Vt.toneMapping!==Ae||Vt.morphTargetsCount!==ue)&&(_e=!0):(_e=!0,Vt.__version=Z.version);let Rn=Vt.currentProgram;_e===!0&&(Rn=Zs(Z,z,W));let ui=!1,gn=!1,vs=!1;const Pe=Rn.getUniforms(),Vn=Vt.uniforms;if(Wt.useProgram(Rn.program)&&(ui=!0,gn=!0,vs=!0),Z.id!==E&&(E=Z.id,gn=!0),ui||b!==T){Wt.buffers.depth.getReversed()?(ht.copy(T.projectionMatrix),wC(ht),EC(ht),Pe.setValue(G,"projectionMatrix",ht)):Pe.setValue(G,"projectionMatrix",T.projectionMatrix),Pe.setValue(G,"viewMatrix",T.matrixWorldInverse);const di=Pe.map.cameraPosition;di!==void 0&&di.setValue(G,zt.setFromMatrixPosition(T.matrixWorld)),ie.logarithmicDepthBuffer&&Pe.setValue(G,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&Pe.setValue(G,"isOrthographic",T.isOrthographicCamera===!0),b!==T&&(b=T,gn=!0,vs=!0)}if(W.isSkinnedMesh){Pe.setOptional(G,W,"bindMatrix"),Pe.setOptional(G,W,"bindMatrixInverse");const bn=W.skeleton;bn&&(bn.boneTexture===null&&bn.computeBoneTexture(),Pe.setValue(G,"boneTexture",bn.boneTexture,D))}W.isBatchedMesh&&(Pe.setOptional(G,W,"batchingTexture"),Pe.setValue(G,"batchingTexture",W._matricesTexture,D),Pe.setOptional(G,W,"batchingIdTexture"),Pe.setValue(G,"batchingIdTexture",W._indirectTexture,D),Pe.setOptional(G,W,"batchingColorTexture"),W._colorsTexture!==null&&Pe.setValue(G,"batchingColorTexture",W._colorsTexture,D));const $i=K.morphAttributes;if(($i.position!==void 0||$i.normal!==void 0||$i.color!==void 0)&&Ht.update(W,K,Rn),(gn||Vt.receiveShadow!==W.receiveShadow)&&(Vt.receiveShadow=W.receiveShadow,Pe.setValue(G,"receiveShadow",W.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(Vn.envMap.value=kt,Vn.flipEnvMap.value=kt.isCubeTexture&&kt.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&z.environment!==null&&(Vn.envMapIntensity.value=z.environmentIntensity),gn&&(Pe.setValue(G,"toneMappingExposure",x.toneMappingExposure),Vt.needsLights&&_s(Vn,vs),ft&&Z.fog===!0&&bt.refreshFogUniforms(Vn,ft),bt.refreshMaterialUniforms(Vn,Z,Q,j,f.state.transmissionRenderTarget[T.id]),Ea.upload(G,Lr(Vt),Vn,D)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Ea.upload(G,Lr(Vt),Vn,D),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&Pe.setValue(G,"center",W.center),Pe.setValue(G,"modelViewMatrix",W.modelViewMatrix),Pe.setValue(G,"normalMatrix",W.normalMatrix),Pe.setValue(G,"modelMatrix",W.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){const bn=Z.uniformsGroups;for(let di=0,Yn=bn.length;di<Yn;di++){const Js=bn[di];V.update(Js,Rn),V.bind(Js,Rn)}}return Rn}function _s(T,z){T.ambientLightColor.needsUpdate=z,T.lightProbe.needsUpdate=z,T.directionalLights.needsUpdate=z,T.directionalLightShadows.needsUpdate=z,T.pointLights.needsUpdate=z,T.pointLightShadows.needsUpdate=z,T.spotLights.needsUpdate=z,T.spotLightShadows.needsUpdate=z,T.rectAreaLights.needsUpdate=z,T.hemisphereLights.needsUpdate=z}function Dr(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return P},this.getActiveMipmapLevel=function(){return A},this.getRenderTarget=function(){return I},this.setRenderTargetTextures=function(T,z,K){Dt.get(T.texture).__webglTexture=z,Dt.get(T.depthTexture).__webglTexture=K;const Z=Dt.get(T);Z.__hasExternalTextures=!0,Z.__autoAllocateDepthBuffer=K===void 0,Z.__autoAllocateDepthBuffer||te.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),Z.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(T,z){const K=Dt.get(T);K.__webglFramebuffer=z,K.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(T,z=0,K=0){I=T,P=z,A=K;let Z=!0,W=null,ft=!1,wt=!1;if(T){const kt=Dt.get(T);if(kt.__useDefaultFramebuffer!==void 0)Wt.bindFramebuffer(G.FRAMEBUFFER,null),Z=!1;else if(kt.__webglFramebuffer===void 0)D.setupRenderTarget(T);else if(kt.__hasExternalTextures)D.rebindTextures(T,Dt.get(T.texture).__webglTexture,Dt.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){const Ft=T.depthTexture;if(kt.__boundDepthTexture!==Ft){if(Ft!==null&&Dt.has(Ft)&&(T.width!==Ft.image.width||T.height!==Ft.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");D.setupDepthRenderbuffer(T)}}const $t=T.texture;($t.isData3DTexture||$t.isDataArrayTexture||$t.isCompressedArrayTexture)&&(wt=!0);const Xt=Dt.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Xt[z])?W=Xt[z][K]:W=Xt[z],ft=!0):T.samples>0&&D.useMultisampledRTT(T)===!1?W=Dt.get(T).__webglMultisampledFramebuffer:Array.isArray(Xt)?W=Xt[K]:W=Xt,R.copy(T.viewport),H.copy(T.scissor),O=T.scissorTest}else R.copy(gt).multiplyScalar(Q).floor(),H.copy(xt).multiplyScalar(Q).floor(),O=mt;if(Wt.bindFramebuffer(G.FRAMEBUFFER,W)&&Z&&Wt.drawBuffers(T,W),Wt.viewport(R),Wt.scissor(H),Wt.setScissorTest(O),ft){const kt=Dt.get(T.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+z,kt.__webglTexture,K)}else if(wt){const kt=Dt.get(T.texture),$t=z||0;G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,kt.__webglTexture,K||0,$t)}E=-1},this.readRenderTargetPixels=function(T,z,K,Z,W,ft,wt){if(!(T&&T.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=Dt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&wt!==void 0&&(Bt=Bt[wt]),Bt){Wt.bindFramebuffer(G.FRAMEBUFFER,Bt);try{const kt=T.texture,$t=kt.format,Xt=kt.type;if(!ie.textureFormatReadable($t)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!ie.textureTypeReadable(Xt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=T.width-Z&&K>=0&&K<=T.height-W&&G.readPixels(z,K,Z,W,Yt.convert($t),Yt.convert(Xt),ft)}finally{const kt=I!==null?Dt.get(I).__webglFramebuffer:null;Wt.bindFramebuffer(G.FRAMEBUFFER,kt)}}},this.readRenderTargetPixelsAsync=async function(T,z,K,Z,W,ft,wt){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=Dt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&wt!==void 0&&(Bt=Bt[wt]),Bt){const kt=T.texture,$t=kt.format,Xt=kt.type;if(!ie.textureFormatReadable($t))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!ie.textureTypeReadable(Xt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(z>=0&&z<=T.width-Z&&K>=0&&K<=T.height-W){Wt.bindFramebuffer(G.FRAMEBUFFER,Bt);const Ft=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,Ft),G.bufferData(G.PIXEL_PACK_BUFFER,ft.byteLength,G.STREAM_READ),G.readPixels(z,K,Z,W,Yt.convert($t),Yt.convert(Xt),0);const ae=I!==null?Dt.get(I).__webglFramebuffer:null;Wt.bindFramebuffer(G.FRAMEBUFFER,ae);const Ee=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await SC(G,Ee,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,Ft),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,ft),G.deleteBuffer(Ft),G.deleteSync(Ee),ft}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(T,z=null,K=0){T.isTexture!==!0&&(_r("WebGLRenderer: copyFramebufferToTexture function signature has changed."),z=arguments[0]||null,T=arguments[1]);const Z=Math.pow(2,-K),W=Math.floor(T.image.width*Z),ft=Math.floor(T.image.height*Z),wt=z!==null?z.x:0,Bt=z!==null?z.y:0;D.setTexture2D(T,0),G.copyTexSubImage2D(G.TEXTURE_2D,K,0,0,wt,Bt,W,ft),Wt.unbindTexture()},this.copyTextureToTexture=function(T,z,K=null,Z=null,W=0){T.isTexture!==!0&&(_r("WebGLRenderer: copyTextureToTexture function signature has changed."),Z=arguments[0]||null,T=arguments[1],z=arguments[2],W=arguments[3]||0,K=null);let ft,wt,Bt,kt,$t,Xt,Ft,ae,Ee;const Ae=T.isCompressedTexture?T.mipmaps[W]:T.image;K!==null?(ft=K.max.x-K.min.x,wt=K.max.y-K.min.y,Bt=K.isBox3?K.max.z-K.min.z:1,kt=K.min.x,$t=K.min.y,Xt=K.isBox3?K.min.z:0):(ft=Ae.width,wt=Ae.height,Bt=Ae.depth||1,kt=0,$t=0,Xt=0),Z!==null?(Ft=Z.x,ae=Z.y,Ee=Z.z):(Ft=0,ae=0,Ee=0);const on=Yt.convert(z.format),ue=Yt.convert(z.type);let Vt;z.isData3DTexture?(D.setTexture3D(z,0),Vt=G.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(D.setTexture2DArray(z,0),Vt=G.TEXTURE_2D_ARRAY):(D.setTexture2D(z,0),Vt=G.TEXTURE_2D),G.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,z.flipY),G.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),G.pixelStorei(G.UNPACK_ALIGNMENT,z.unpackAlignment);const Be=G.getParameter(G.UNPACK_ROW_LENGTH),_e=G.getParameter(G.UNPACK_IMAGE_HEIGHT),Rn=G.getParameter(G.UNPACK_SKIP_PIXELS),ui=G.getParameter(G.UNPACK_SKIP_ROWS),gn=G.getParameter(G.UNPACK_SKIP_IMAGES);G.pixelStorei(G.UNPACK_ROW_LENGTH,Ae.width),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Ae.height),G.pixelStorei(G.UNPACK_SKIP_PIXELS,kt),G.pixelStorei(G.UNPACK_SKIP_ROWS,$t),G.pixelStorei(G.UNPACK_SKIP_IMAGES,Xt);const vs=T.isDataArrayTexture||T.isData3DTexture,Pe=z.isDataArrayTexture||z.isData3DTexture;if(T.isRenderTargetTexture||T.isDepthTexture){const Vn=Dt.get(T),$i=Dt.get(z),bn=Dt.get(Vn.__renderTarget),di=Dt.get($i.__renderTarget);Wt.bindFramebuffer(G.READ_FRAMEBUFFER,bn.__webglFramebuffer),Wt.bindFramebuffer(G.DRAW_FRAMEBUFFER,di.__webglFramebuffer);for(let Yn=0;Yn<Bt;Yn++)vs&&G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Dt.get(T).__webglTexture,W,Xt+Yn),T.isDepthTexture?(Pe&&G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Dt.get(z).__webglTexture,W,Ee+Yn),G.blitFramebuffer(kt,$t,ft,wt,Ft,ae,ft,wt,G.DEPTH_BUFFER_BIT,G.NEAREST)):Pe?G.copyTexSubImage3D(Vt,W,Ft,ae,Ee+Yn,kt,$t,ft,wt):G.copyTexSubImage2D(Vt,W,Ft,ae,Ee+Yn,kt,$t,ft,wt);Wt.bindFramebuffer(G.READ_FRAMEBUFFER,null),Wt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else Pe?T.isDataTexture||T.isData3DTexture?G.texSubImage3D(Vt,W,Ft,ae,Ee,ft,wt,Bt,on,ue,Ae.data):z.isCompressedArrayTexture?G.compressedTexSubImage3D(Vt,W,Ft,ae,Ee,ft,wt,Bt,on,Ae.data):G.texSubImage3D(Vt,W,Ft,ae,Ee,ft,wt,Bt,on,ue,Ae):T.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,W,Ft,ae,ft,wt,on,ue,Ae.data):T.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,W,Ft,ae,Ae.width,Ae.height,on,Ae.data):G.texSubImage2D(G.TEXTURE_2D,W,Ft,ae,ft,wt,on,ue,Ae);G.pixelStorei(G.UNPACK_ROW_LENGTH,Be),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,_e),G.pixelStorei(G.UNPACK_SKIP_PIXELS,Rn),G.pixelStorei(G.UNPACK_SKIP_ROWS,ui),G.pixelStorei(G.UNPACK_SKIP_IMAGES,gn),W===0&&z.generateMipmaps&&G.generateMipmap(Vt),Wt.unbindTexture()},this.copyTextureToTexture3D=function(T,z,K=null,Z=null,W=0){return T.isTexture!==!0&&(_r("WebGLRenderer: copyTextureToTexture3D function signature has changed."),K=arguments[0]||null,Z=arguments[1]||null,T=arguments[2],z=arguments[3],W=arguments[4]||0),_r('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(T,z,K,Z,W)},this.initRenderTarget=function(T){Dt.get(T).__webglFramebuffer===void 0&&D.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?D.setTextureCube(T,0):T.isData3DTexture?D.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?D.setTexture2DArray(T,0):D.setTexture2D(T,0),Wt.unbindTexture()},this.resetState=function(){P=0,A=0,I=null,Wt.reset(),ge.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Oi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}}class tu{constructor(t,e=1,n=1e3){this.isFog=!0,this.name="",this.color=new pe(t),this.near=e,this.far=n}clone(){return new tu(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}}class UI extends pn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new wi,this.environmentIntensity=1,this.environmentRotation=new wi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}}class kI extends Tn{constructor(t,e,n,s,o,r,a,l,c){super(t,e,n,s,o,r,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}}class $o extends ms{constructor(t=1,e=1,n=1,s=32,o=1,r=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:o,openEnded:r,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),o=Math.floor(o);const h=[],u=[],d=[],p=[];let _=0;const g=[],m=n/2;let f=0;M(),r===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new Si(u,3)),this.setAttribute("normal",new Si(d,3)),this.setAttribute("uv",new Si(p,2));function M(){const x=new et,k=new et;let P=0;const A=(e-t)/n;for(let I=0;I<=o;I++){const E=[],b=I/o,R=b*(e-t)+t;for(let H=0;H<=s;H++){const O=H/s,q=O*l+a,$=Math.sin(q),X=Math.cos(q);k.x=R*$,k.y=-b*n+m,k.z=R*X,u.push(k.x,k.y,k.z),x.set($,A,X).normalize(),d.push(x.x,x.y,x.z),p.push(O,1-b),E.push(_++)}g.push(E)}for(let I=0;I<s;I++)for(let E=0;E<o;E++){const b=g[E][I],R=g[E+1][I],H=g[E+1][I+1],O=g[E][I+1];(t>0||E!==0)&&(h.push(b,R,O),P+=3),(e>0||E!==o-1)&&(h.push(R,H,O),P+=3)}c.addGroup(f,P,0),f+=P}function S(x){const k=_,P=new xe,A=new et;let I=0;const E=x===!0?t:e,b=x===!0?1:-1;for(let H=1;H<=s;H++)u.push(0,m*b,0),d.push(0,b,0),p.push(.5,.5),_++;const R=_;for(let H=0;H<=s;H++){const q=H/s*l+a,$=Math.cos(q),X=Math.sin(q);A.x=E*X,A.y=m*b,A.z=E*$,u.push(A.x,A.y,A.z),d.push(0,b,0),P.x=$*.5+.5,P.y=X*.5*b+.5,p.push(P.x,P.y),_++}for(let H=0;H<s;H++){const O=k+H,q=R+H;x===!0?h.push(q,q+1,O):h.push(q+1,q,O),I+=3}c.addGroup(f,I,x===!0?1:2),f+=I}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new $o(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}}class Jm extends Cr{static get type(){return"MeshStandardMaterial"}constructor(t){super(),this.isMeshStandardMaterial=!0,this.defines={STANDARD:""},this.color=new pe(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new pe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Im,this.normalScale=new xe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}}class eu extends pn{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new pe(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){const e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}}class FI extends eu{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(pn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new pe(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}}const oc=new Ve,Wf=new et,$f=new et;class OI{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new xe(512,512),this.map=null,this.mapPass=null,this.matrix=new Ve,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Jh,this._frameExtents=new xe(1,1),this._viewportCount=1,this._viewports=[new $e(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){const e=this.camera,n=this.matrix;Wf.setFromMatrixPosition(t.matrixWorld),e.position.copy(Wf),$f.setFromMatrixPosition(t.target.matrixWorld),e.lookAt($f),e.updateMatrixWorld(),oc.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(oc),n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(oc)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}}class BI extends OI{constructor(){super(new qm(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class zI extends eu{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(pn.DEFAULT_UP),this.updateMatrix(),this.target=new pn,this.shadow=new BI}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}}class HI extends eu{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}}const qf=new Ve;class VI{constructor(t,e,n=0,s=1/0){this.ray=new Om(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new Kh,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,(e.near+e.far)/(e.near-e.far)).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):console.error("THREE.Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return qf.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(qf),this}intersectObject(t,e=!0,n=[]){return fh(t,this,n,e),n.sort(Xf),n}intersectObjects(t,e=!0,n=[]){for(let s=0,o=t.length;s<o;s++)fh(t[s],this,n,e);return n.sort(Xf),n}}function Xf(i,t){return i.distance-t.distance}function fh(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){const o=i.children;for(let r=0,a=o.length;r<a;r++)fh(o[r],t,e,!0)}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Vh}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Vh);const GI=.3,jf=.8;function Qm(i){return i.body_height+2*i.wheel_radius}function tg(i,t){const e=i/Qm(t)*GI*t.weight;return Math.max(-jf*t.weight,Math.min(jf*t.weight,e))}const WI=120,Eo=.1,Ba=60,Yf=1920;function $I(i,t){return-i*t*1.55}class qI{constructor(t,e,n){this.look=t,this.own=e;const s=(o,r=.7,a=0)=>{const l=new Jm({color:o,roughness:r,metalness:a});return n&&(l.color.set(e),l.transparent=!0,l.opacity=.3),l};this.build(s,!n),this.root.add(this.body,...this.wheels),this.body.position.y=t.wheel_radius,this.root.traverse(o=>{o instanceof fn&&(o.castShadow=o.receiveShadow=!n)})}root=new bi;body=new bi;wheels=[new bi,new bi];x=0;z=0;last=null;build(t,e){const{wheel_radius:n,track:s,body_height:o,body_depth:r}=this.look,a=Math.max(s*.62,.02),l=n*.25,c=(u,d,p,_,g,m,f)=>{const M=new fn(new js(p,d,u),_);M.position.set(g,m,f),this.body.add(M)},h=t(this.own,.55);if(c(a,o*.94,r,h,0,l+o*.5,0),e&&c(s*.8,n*.5,r*.55,t("#3b424a",.6),0,0,0),e&&this.look.command_unit!=="V")for(const u of[.22,.5,.78])c(a*1.01,o*.03,r*1.02,t("#20262c",.6),0,l+o*u,0);else if(e){c(a*.72,o*.26,r*.04,t("#20262c",.25),r*.5,l+o*.72,0),c(a*.62,o*.18,r*.05,t("#b9d8c4",.3),r*.505,l+o*.73,0),c(a*.16,o*.08,r*.08,t("#f4f5f6",.5),r*.5,l+o*.42,0);for(const u of[-1,1])c(a*.14,o*.06,r*.07,t("#8b949d",.5),r*.5,l+o*.42,u*a*.22)}if(this.look.payload>0&&e){const u=Math.cbrt(this.look.payload/2500),d=this.look.payload_height-u/2-l;d>0&&c(.008,d,.008,t("#5c656e",.6),0,l+d/2,0),c(u,u,u,t("#8c5a2b",.8),0,this.look.payload_height,0)}this.wheels.forEach((u,d)=>this.tyre(u,d===0?-s/2:s/2,t,e))}tyre(t,e,n,s){const o=this.look.wheel_radius,r=Math.min(this.look.track*.16,o*.7),a=new fn(new $o(o,o,r,40),n("#23272c",.95)),l=new fn(new $o(o*.66,o*.66,r*1.04,32),n("#c9ced3",.45,.1));a.rotation.x=l.rotation.x=Math.PI/2,t.add(a),s&&t.add(l);for(let c=0;s&&c<3;c+=1){const h=new fn(new js(o*1.2,o*.13,r*1.1),n("#5c656e",.6));h.rotation.z=c*Math.PI/3,t.add(h)}t.position.set(0,o,e)}move(t,e){const{wheel_radius:n,track:s}=this.look,[o,,r,,a]=t;if(this.last!==null){const c=n*(r-this.last);this.x+=c*Math.cos(a),this.z-=c*Math.sin(a)}this.last=r,this.root.rotation.y=a,this.root.position.set(this.x+e*Math.sin(a),0,this.z+e*Math.cos(a)),this.body.rotation.z=-o;const l=s/(2*n)*a;this.wheels[0].rotation.z=-(r-l),this.wheels[1].rotation.z=-(r+l)}shift(t,e){this.x+=t,this.z+=e}start(t){t&&([this.x,this.z,this.last]=[t.x,t.z,t.last])}}function XI(i){const t=document.createElement("canvas");t.width=t.height=128;const e=t.getContext("2d");e.fillStyle=i?"#252b32":"#eeeeec",e.fillRect(0,0,128,128),e.strokeStyle=i?"#39424b":"#cfd1d2",e.lineWidth=2,e.strokeRect(0,0,128,128);const n=new kI(t);return n.wrapS=n.wrapT=ka,n.repeat.set(Ba,Ba),n.anisotropy=8,n.colorSpace=Bn,n}class jI{constructor(t,e){this.canvas=t,this.push=e,this.element=t,this.renderer=new NI({canvas:t,antialias:!0}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=bm,this.floor=new fn(new Pr(Ba*Eo,Ba*Eo),new Jm({roughness:.95})),this.floor.rotation.x=-Math.PI/2,this.floor.receiveShadow=!0,this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=6,this.sun.shadow.bias=-5e-4,this.shaft=new fn(new $o(1,1,1,16),this.ink),this.head=new fn(new $o(0,1,1,24),this.ink),this.arrow.add(this.shaft,this.head),this.arrow.visible=!1,this.ground.add(this.floor,this.arrow),this.scene.add(this.ground,this.sky,this.sun,this.sun.target,new HI("#ffffff",.35)),this.paint(),this.listen()}renderer;scene=new UI;camera=new jn(32,1,.02,30);sun=new zI("#fffdf8",2.4);sky=new FI("#ffffff","#c4c6c8",1.1);floor;ground=new bi;figures=[];bodies=[];look=null;arrow=new bi;shaft;head;ink=new Zh;eye={azimuth:.5,height:.26,away:1};grip=null;turning=null;centre=new et;calm=matchMedia("(prefers-reduced-motion: reduce)");slow=0;detail=1;seen=-1;stale=!0;element;paint(){const t=document.documentElement.dataset.theme==="dark";this.ink.color.set(ds().push);const e=new pe(t?"#1b2026":"#f4f3ef");this.scene.background=e,this.scene.fog=new tu(e,1.2*this.size()+1.2,3*this.size()+2.2),this.floor.material.map=XI(t),this.floor.material.needsUpdate=!0,this.sun.intensity=t?1.7:1.9,this.stale=!0,this.sky.intensity=t?.7:1;const[n,s]=[this.look,this.bodies];n&&this.furnish(n,s)}furnish(t,e){const n=new Map(this.bodies.map((a,l)=>[a,this.figures[l]]));for(const a of this.figures)this.ground.remove(a.root);const s=this.look===null;this.look=t,this.bodies=e,this.seen=-1,this.stale=!0,this.figures=e.map((a,l)=>new qI(t,rs(a),l>0)),this.figures.forEach((a,l)=>a.start(n.get(e[l])));for(const a of this.figures)this.ground.add(a.root);const o=this.size(),r=o*2.2;Object.assign(this.sun.shadow.camera,{left:-r,right:r,top:r,bottom:-r,near:.01,far:o*12}),this.sun.shadow.camera.updateProjectionMatrix(),s&&this.paint()}size(){return this.look?Math.max(Qm(this.look),this.look.payload>0?1.1*(this.look.payload_height+this.look.wheel_radius):0):.25}move(t){if(!this.look||t.x.length!==this.figures.length||t.n===this.seen)return;this.seen=t.n,this.stale=!0;const e=this.look.track;this.ground.rotation.z=t.f[2],this.figures.forEach((s,o)=>s.move(t.x[o],$I(o,e)));const n=this.figures[0];if(Math.hypot(n.x,n.z)>3){const s=a=>-Math.round(a/Eo)*Eo,[o,r]=[s(n.x),s(n.z)];for(const a of this.figures)a.shift(o,r);this.centre.add(new et(o,0,r))}this.show(t.f[0],t.f[1],t.x[0][0],t.x[0][4])}show(t,e,n,s){const o=this.look,r=this.figures[0].root.position;if(this.arrow.visible=Math.abs(t)>.005,!this.arrow.visible)return;const a=Math.min(.04+Math.abs(t)/o.weight*this.size()*1.2,this.size()*1.6),l=new et(Math.cos(s),0,-Math.sin(s)).multiplyScalar(Math.sign(t)),c=e*Math.sin(n),h=new et(r.x+c*Math.cos(s),o.wheel_radius+e*Math.cos(n),r.z-c*Math.sin(s)),u=o.body_depth/2+.004;this.arrow.position.copy(h).addScaledVector(l,-a-u),this.arrow.quaternion.setFromUnitVectors(new et(0,1,0),l);const[d,p]=[this.size()*.014,Math.min(a*.6,this.size()*.13)];this.shaft.scale.set(d,a-p,d),this.shaft.position.y=(a-p)/2,this.head.scale.set(3*d,p,3*d),this.head.position.y=a-p/2}draw(t){const{clientWidth:e,clientHeight:n}=this.canvas;if(!e||!n)return;this.pace(t);const s=Math.min(devicePixelRatio,2)*this.detail,o=this.renderer.getDrawingBufferSize(new xe);(Math.abs(o.x-e*s)>1||Math.abs(o.y-n*s)>1)&&(this.renderer.setPixelRatio(s),this.renderer.setSize(e,n,!1),this.camera.aspect=e/n,this.camera.updateProjectionMatrix(),this.stale=!0),this.stale&&(this.stale=this.follow(t),this.pull(),this.renderer.render(this.scene,this.camera))}pace(t){this.slow=t>45?this.slow+1:Math.max(0,this.slow-.5),this.slow>40&&this.detail>.8&&(this.detail*=.75,this.slow=0)}follow(t){const e=this.figures[0],n=this.size();e&&this.centre.lerp(new et(e.x,0,e.z),this.calm.matches?1:1-Math.exp(-t/WI));const s=this.camera.aspect<1?1.25:1,o=n*3.5*this.eye.away*s,{azimuth:r,height:a}=this.eye,l=o*Math.cos(a);this.ground.updateMatrixWorld();const c=this.ground.localToWorld(this.centre.clone()),h=c.clone().setY(c.y+n*.42);this.camera.position.set(h.x+l*Math.sin(r),h.y+o*Math.sin(a),h.z+l*Math.cos(r)),this.camera.lookAt(h),this.sun.position.set(c.x-n*2,c.y+n*5,c.z+n*2.4),this.sun.target.position.copy(c);const u=d=>Math.round(d/Eo)*Eo;return this.floor.position.set(u(this.centre.x),0,u(this.centre.z)),e?Math.hypot(e.x-this.centre.x,e.z-this.centre.z)>.001:!1}picture(t){const{clientWidth:e,clientHeight:n}=this.canvas;this.renderer.setPixelRatio(Yf/e),this.renderer.setSize(e,n,!1),this.renderer.render(this.scene,this.camera);const{width:s,height:o}=this.canvas,[r,a]=[document.createElement("canvas"),Math.round(Yf/28)];Object.assign(r,{width:s,height:o+a});const l=r.getContext("2d"),c=getComputedStyle(document.documentElement);return l.fillStyle=c.getPropertyValue("--card"),l.fillRect(0,0,s,o+a),l.drawImage(this.canvas,0,0),Object.assign(l,{fillStyle:c.getPropertyValue("--ink"),font:`${.45*a}px system-ui, sans-serif`,textBaseline:"middle"}),l.fillText(t,.4*a,o+a/2,s-.8*a),this.stale=!0,this.draw(0),new Promise(h=>r.toBlob(h))}turn(t,e){this.stale=!0,this.eye.azimuth+=t,this.eye.height=Math.min(1.2,Math.max(.03,this.eye.height+e))}zoom(t){this.stale=!0,this.eye.away=Math.min(3,Math.max(.45,this.eye.away*t))}grasp(){const t=this.look;if(!t)return{x:0,y:0};const e=this.figures[0].body.localToWorld(new et(0,t.body_height*.6,0)).project(this.camera);return{x:(e.x+1)/2*this.canvas.clientWidth,y:(1-e.y)/2*this.canvas.clientHeight}}pointer(t){const e=this.canvas.getBoundingClientRect();return new xe((t.clientX-e.left)/e.width*2-1,1-(t.clientY-e.top)/e.height*2)}ray(t){const e=new VI;return e.setFromCamera(t,this.camera),e}listen(){this.canvas.addEventListener("pointerdown",t=>this.down(t)),this.canvas.addEventListener("pointermove",t=>this.moved(t));for(const t of["pointerup","pointercancel","lostpointercapture"])this.canvas.addEventListener(t,()=>this.up());this.canvas.addEventListener("wheel",t=>{t.preventDefault(),this.zoom(Math.exp(t.deltaY/900))},{passive:!1})}down(t){if(!this.look||!this.figures.length)return;this.canvas.setPointerCapture(t.pointerId);const e=this.pointer(t),n=this.ray(e).intersectObject(this.figures[0].root,!0)[0];if(!n){this.turning={x:t.clientX,y:t.clientY};return}const s=this.figures[0].body.worldToLocal(n.point.clone());this.grip={at:s,mouse:e,height:Math.max(0,s.y)},this.pull(),this.canvas.classList.add("holding")}moved(t){this.turning&&(this.turn((this.turning.x-t.clientX)/160,(t.clientY-this.turning.y)/260),this.turning={x:t.clientX,y:t.clientY}),this.grip&&(this.grip.mouse=this.pointer(t),this.pull())}pull(){const[t,e]=[this.grip,this.look];if(!t||!e)return;const n=this.figures[0],s=n.body.localToWorld(t.at.clone()),o=this.camera.position.clone().sub(s).setY(0).normalize(),r=new ss().setFromNormalAndCoplanarPoint(o,s),a=this.ray(t.mouse).ray.intersectPlane(r,new et);if(!a)return;const l=n.root.rotation.y,c=a.sub(s).dot(new et(Math.cos(l),0,-Math.sin(l)).applyQuaternion(this.ground.quaternion));this.push({force:tg(c,e),height:t.height})}up(){this.turning=null,this.grip&&(this.grip=null,this.canvas.classList.remove("holding"),this.push({force:0,height:0}))}}const To=170,YI=110,Kf=600;class KI{constructor(t){this.push=t,this.element.addEventListener("pointerdown",e=>this.down(e)),this.element.addEventListener("pointermove",e=>this.moved(e));for(const e of["pointerup","pointercancel"])this.element.addEventListener(e,()=>this.up())}element=de("svg",{viewBox:"-200 0 400 200",class:"room flat",role:"img",tabindex:"0"});sides=[];ground=de("g");arrow=de("path",{class:"arrow"});look=null;grip=null;furnish(t,e){this.look=t,this.element.replaceChildren(this.ground),this.ground.replaceChildren(de("line",{x1:-Kf,x2:Kf,y1:To,y2:To,class:"ground"})),this.sides=e.map((n,s)=>this.side(t,n,s>0)).reverse();for(const n of this.sides)this.ground.append(n.root);this.sides.reverse(),this.ground.append(this.arrow)}scale(t){return YI/(Math.max(t.body_height,t.payload>0?t.payload_height:0)+t.wheel_radius)}side(t,e,n){const s=this.scale(t),[o,r,a]=[t.wheel_radius*s,t.body_height*s,t.body_depth*s],l=n?{fill:"none",stroke:rs(e),"stroke-width":2,opacity:.7}:{},c=n?{}:{fill:rs(e)},h=de("g");if(h.append(de("rect",{x:-a/2,y:-r-o*.25,width:a,height:r,rx:3,class:n?"":"shell",...l,...c})),t.payload>0&&!n){const[p,_]=[Math.cbrt(t.payload/2500)*s,t.payload_height*s];h.append(de("path",{d:`M0 0V${-_}`,class:"carrier"}),de("rect",{x:-p/2,y:-_-p/2,width:p,height:p,class:"payload"}))}const u=de("g");u.append(de("circle",{r:o,class:n?"":"tyre",...l}),de("path",{d:`M${-o*.6} 0H${o*.6}M0 ${-o*.6}V${o*.6}`,class:n?"":"spokes",...l}));const d=de("g");return d.append(h,u),{root:d,body:h,wheel:u}}move(t){const e=this.look;if(!e||t.x.length!==this.sides.length)return;const n=this.scale(e),s=180/Math.PI;this.ground.setAttribute("transform",`rotate(${-t.f[2]*s} 0 ${To})`),this.sides.forEach((u,d)=>{const[p,,_]=t.x[d],g=(_-t.x[0][2])*e.wheel_radius*n;u.root.setAttribute("transform",`translate(${g} ${To-e.wheel_radius*n})`),u.body.setAttribute("transform",`rotate(${p*s})`),u.wheel.setAttribute("transform",`rotate(${_*s})`)});const[o,r]=t.f,a=o/e.weight*150,[l,c]=[r*Math.sin(t.x[0][0])*n,To-(e.wheel_radius+r*Math.cos(t.x[0][0]))*n],h=Math.sign(o)*7;this.arrow.setAttribute("d",Math.abs(o)>.005?`M${l-a-h} ${c}H${l}m${-h} -5L${l} ${c}l${-h} 5`:"")}picture(){return Promise.resolve(new Blob([new XMLSerializer().serializeToString(this.element)],{type:"image/svg+xml"}))}grasp(){const t=(this.sides[0]?.body.firstElementChild??this.element).getBoundingClientRect(),e=this.element.getBoundingClientRect();return{x:t.x-e.x+t.width/2,y:t.y-e.y+t.height*.4}}down(t){const e=this.sides[0];if(!this.look||!e?.root.contains(t.target))return;this.element.setPointerCapture(t.pointerId);const n=this.element.getBoundingClientRect().height/200,s=this.element.getBoundingClientRect().y+(To-this.look.wheel_radius*this.scale(this.look))*n;this.grip={x:t.clientX,height:Math.max(0,(s-t.clientY)/n/this.scale(this.look))},this.push({force:0,height:this.grip.height})}moved(t){if(!this.grip||!this.look)return;const e=this.scale(this.look)*this.element.getBoundingClientRect().height/200;this.push({force:tg((t.clientX-this.grip.x)/e,this.look),height:this.grip.height})}up(){this.grip&&(this.grip=null,this.push({force:0,height:0}))}}const ZI=["loop","portrait","voltages","estimate","equations"],fa=8,JI=["ψ̇","ψ̈","θ̇","θ̈","φ̇","φ̈"];class QI{root=U("div.see");view="loop";stage=U("div.stage");strips=[];build(){const t=ZI.map(n=>[n,F(n)]),e=us(F("viewLabel"),t,this.view,n=>{this.view=n,this.update()},"view");jt(this.root,e,this.stage),this.update()}update(){this.strips=[],this.view==="loop"?jt(this.stage,...this.loop()):this.view==="equations"?jt(this.stage,...i3()):this.view==="voltages"?this.voltages():this.view==="estimate"?this.estimate():this.portrait()}draw(){if(this.view==="portrait"&&this.portrait(),!this.strips.length)return;const t=C.traces,e=t.t.at(-1)??0,n=t.since(e-fa),s=t.t.slice(n),o=r=>r.slice(n);if(this.view==="estimate")this.strips[0].show(s,[t.x[0]?.[0]??[],t.estimate].map(r=>va(o(r))),e-fa,e);else{const r=[1,2].map((a,l)=>o(t.saturated).map((c,h)=>c&a?t.volts[l][n+h]:NaN));this.strips.forEach((a,l)=>a.show(s,[o(t.volts[l]),r[l]],e-fa,e))}}voltages(){const{text:t,push:e}=ds(),{unit:n}=C;this.strips=[F("leftMotor"),F("rightMotor")].map(o=>new bc(o,n,[{label:o,colour:t,dash:[]},{label:F("saturated"),colour:e,dash:[],width:5}],150,1));const s=U("p.note",F(n==="V"?"voltagesNote":"torquesNote"));jt(this.stage,s,...this.strips.map(o=>o.root))}estimate(){if(!C.snapshot?.e.length){jt(this.stage,U("p.note",F("noEstimate")));return}const{push:t}=ds(),e=[{label:F("truth"),colour:rs(C.changed?.bodies[0]??"twin"),dash:[]},{label:F("opinion"),colour:t,dash:[4,3]}];this.strips=[new bc(`ψ: ${F("truth")} ──  ${F("opinion")} ╌╌`,"°",e,190,1)],jt(this.stage,U("p.note",F("estimateNote")),this.strips[0].root)}portrait(){const{traces:t}=C,{t:e,x:n}=t,s=t.since((e.at(-1)??0)-fa),o=(r,a)=>{const l=n.map((d,p)=>{const _=C.changed?.bodies[p]??"";return{x:va(d[r].slice(s)),y:va(d[r+1].slice(s)),colour:rs(_),dash:Fh(_,C.changed?.bodies??[])}}),c=(d,p)=>{const _=l.flatMap(f=>f[d]),[g,m]=[_.reduce((f,M)=>Math.min(f,M),1/0),_.reduce((f,M)=>Math.max(f,M),-1/0)];return im(g,m,p)},h=l.map(d=>({x:d.x.at(-1)??0,y:d.y.at(-1)??0,colour:d.colour})),u=Ye($s[r]);return za(u,La({title:`${F("portrait")}: ${u}`,xLabel:`${Hs[r]} [°]`,yLabel:`${Hs[r+1]} [°/s]`,lines:l,points:h,x:c("x",a[0]),y:c("y",a[1]),square:!0}))};jt(this.stage,o(0,[2,20]),o(2,[30,60]),o(4,[3,12]))}loop(){const{analysed:t}=C,e=fm();if(!t||C.off)return e;const n=rs("twin");return t.L.length===3&&e.push(...t3(t.L,n)),t.poles.length&&e.push(e3(t.poles,n)),e}}function t3([i,t,e],n){const s=i.map((u,d)=>20*Math.log10(Math.hypot(t[d],e[d]))),o=n3(i.map((u,d)=>Math.atan2(e[d],t[d])*180/Math.PI)),r=[i[0],i.at(-1)],a=(u,d)=>[Math.min(...u)-d,Math.max(...u)+d],l=(u,d,p,_)=>[La({title:F("bode"),xLabel:"ω [rad/s]",yLabel:u,lines:[{x:i,y:d,colour:n}],x:r,y:a(d,p),logX:!0,marks:[{y:_}],read:!0}),U("output")],c=e.map(u=>-u),h=La({title:F("nyquist"),xLabel:"Re L",yLabel:"Im L",square:!0,x:[-3.2,1.6],y:[-2,2],circle:!0,lines:[{x:t,y:e,colour:n},{x:t,y:c,colour:n,dash:[4,3]}],points:[{x:-1,y:0,colour:ds().push,cross:!0}]});return[za(F("bode"),...l("|L| [dB]",s,3,0),...l("∠L [°]",o,8,-180)),za(F("nyquist"),h)]}function e3(i,t){const e=i.map(([o,r])=>({x:o,y:r,colour:Math.hypot(o,r)>=1?ds().push:t,cross:!0})),n=Math.max(1.15,...i.map(([o,r])=>Math.max(Math.abs(o),Math.abs(r))*1.1)),s=n*1.2;return za(F("poles"),La({title:F("poles"),xLabel:"Re z",yLabel:"Im z",points:e,x:[-s,s],y:[-n,n],square:!0,circle:!0}))}function za(i,...t){return U("figure.titled",{"aria-label":i},U("figcaption",i),...t)}function n3(i){let t=0;return i.map((e,n)=>(n&&(t+=Math.round((i[n-1]-e)/360)*360),e+t)).map((e,n,s)=>e-Math.round((s[0]+180)/360)*360)}function i3(){const i=C.equations;if(!i)return[];const[t,,e,n]=i.inertias.map(x=>fe(x,4)),[s,o,r,a]=[i.alpha,i.beta,i.weight,i.lever].map(x=>fe(x,4)),[l,c]=[fe(i.swing,4),fe(i.half_track,4)],h=`(${a} cos ψ − ${fe(i.lever-i.inertias[1],3)})`,u=C.unit==="rad/s",[d,p,_]=u?["","τ_l","τ_r"]:[`${s} `,"v_l","v_r"],[g,m]=[`${d}(${p} + ${_})`,`2·${o} (θ̇ − ψ̇)`],f=[`${t} θ̈ + ${h} ψ̈ = ${g} − ${m} + ${a} (ψ̇² + φ̇²) sin ψ`,`${h} θ̈ + ${e} ψ̈ = −${g} + ${m} + (${r} + ${l} φ̇² cos ψ) sin ψ`,`(${n} + ${l} sin² ψ) φ̈ = ${c}·${d}(${_} − ${p}) − 2·${c}²·${o} φ̇ − (2·${l} ψ̇ cos ψ + ${a} θ̇) φ̇ sin ψ`,`${u?"τ: (θ̇ − ψ̇)˙ = (v − θ̇ + ψ̇)/T":`α = ${s}   β = ${o}`}   M g L = ${r} N m   M L R = ${a} kg m²   W/2R = ${c}`],M=(x,k)=>Yp([x,...k[0].map((P,A)=>x==="A"?Hs[A]:["v_l","v_r"][A])],k.map((P,A)=>[JI[A],...P.map(I=>fe(I,4))]),"matrix"),S=i.poles.map(([x,k])=>fe(x,4)+(k?` ± ${fe(Math.abs(k),3)}j`:"")).join(";  ");return[U("div.equations",...f.map(x=>U("div",x))),U("p.note",F("equationsNote")),U("p",`${F("openPoles")}: ${S} 1/s`),U("h4",F("linearised")),M("A",i.A),M("B",i.B)]}const Zf=.25,Jf=1.5,s3=.12,o3=.15;class r3{held=new Set;last="";asked=0;padded=!1;constructor(){window.addEventListener("keydown",t=>this.down(t)),window.addEventListener("keyup",t=>this.up(t)),window.addEventListener("blur",()=>this.release())}down(t){t.repeat||vc(t,"input, select, textarea, [role=tab], .table, dialog, dialog *")||/^(Arrow(Up|Down|Left|Right)|f|b)$/.test(t.key)&&(t.preventDefault(),this.held.add(t.key),this.push(),this.steer(...this.keys()))}up(t){this.held.delete(t.key)&&(this.push(),this.steer(...this.keys()))}release(){this.held.size&&(this.held.clear(),this.push(),this.steer(0,0))}keys(){const t=e=>this.held.has(e)?1:0;return[Zf*(t("ArrowUp")-t("ArrowDown")),Jf*(t("ArrowLeft")-t("ArrowRight"))]}pushing=!1;push(){const t=(this.held.has("b")?1:0)-(this.held.has("f")?1:0);if(!t&&!this.pushing)return;this.pushing=t!==0;const e=C.changed?.look;C.push({kind:"Drag",force:t*s3*(e?.weight??6),height:e?.com_height??.07})}steer(t,e){const n=`${t.toFixed(2)} ${e.toFixed(2)}`;n!==this.last&&(this.last=n,C.send({kind:"Steer",speed:t,rate:e}))}tick(t){if(t-this.asked<60)return;this.asked=t;const e=navigator.getGamepads?.().find(s=>s?.connected);if(this.held.size||!e&&!this.padded)return;this.padded=!!e;const n=s=>{const o=e?.axes[s]??0;return Math.abs(o)<o3?0:-o};this.steer(Zf*n(1),Jf*n(0))}}const a3=[.2,3/8,5/9,2/3],l3=(i,t)=>e=>{const n=4*i+e-4,s="*-04-39?2$%%$%%'$%''%'''%')(%'))%(++'(++'(+.'+-.',/3',33)-/5)-43).36)058*18<+37<+4:<,4:E,5<A-7>C/8@F/:EH/<EK0=FM1?IP2@KS3BNV4DPY5FS\\6HV_6IXb7K[e8N^i9Pam;Rdp<Tgt".charCodeAt(n)-35,o=n>8?s:1,r=t/o|0,a=t%o,l=o-a,c=n>8?r*a3[e]+(i>5)&-2:s,h=r-c;return{t:l*h+a*h+a,o:[[l,h],[a,h+1]],i:c}},Qf={M:1},Ks=i=>new Uint8Array(i),xr=i=>{const t=new Error(`lean-qr error ${i}`);throw t.code=i,t},pa=i=>"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:".indexOf(i),ph=i=>i.charCodeAt(0),eg=(...i)=>(t,e)=>i.forEach(n=>n(t,e)),ng=i=>t=>{t.eci!==i&&(t.push(7,4),i<128?t.push(i,8):i<16384?t.push(32768|i,16):t.push(12582912|i,24),t.eci=i)},nu=i=>(t,e)=>{t.push(4,4),t.push(i.length,8+8*(e>9)),i.forEach(n=>t.push(n,8))},Qo=(i,t,e,n,s=(r,a)=>e(r.length,a),o=n?r=>eg(ng(n),i(r)):i)=>(o.test=t,o.l=e,o.est=s,o.eci=n&&[n],o),ig=Qo(i=>(t,e)=>{t.push(1,4),t.push(i.length,10+2*(e>26)+2*(e>9));let n=0;for(;n<i.length-2;n+=3)t.push(+i.slice(n,n+3),10);n<i.length-1?t.push(+i.slice(n),7):n<i.length&&t.push(+i[n],4)},i=>/[0-9]/.test(i),(i,t)=>14+2*(t>26)+2*(t>9)+10*i/3),sg=Qo(i=>(t,e)=>{t.push(2,4),t.push(i.length,9+2*(e>26)+2*(e>9));let n=0;for(;n<i.length-1;n+=2)t.push(45*pa(i[n])+pa(i[n+1]),11);n<i.length&&t.push(pa(i[n]),6)},i=>pa(i)>=0,(i,t)=>13+2*(t>26)+2*(t>9)+5.5*i),qo=Qo(i=>nu([...i].map(ph)),i=>ph(i)<128,(i,t)=>12+8*(t>9)+8*i);qo._=!0,qo.u=!0;const iu=Qo(qo,i=>ph(i)<256,qo.l,3);iu._=!0;const tp=new TextEncoder,su=Qo(i=>nu(tp.encode(i)),()=>1,0,26,(i,t)=>12+8*(t>9)+8*tp.encode(i).length);su._=!0;let mh=()=>{const i=new Map,t=new TextDecoder("sjis"),e=Ks(2);for(let n=0;n<7973;++n)e[0]=n/192+129+64*(n>5951),e[1]=n%192+64,i.set(t.decode(e),n);return i.delete("�"),mh=()=>i,i};const ou=Qo(i=>(t,e)=>{t.push(8,4),t.push(i.length,8+2*(e>26)+2*(e>9));for(const n of i)t.push(mh().get(n),13)},i=>mh().has(i),(i,t)=>12+2*(t>26)+2*(t>9)+13*i);ou._=!0;const og=[ig,sg,qo,iu,ou,su],c3={auto:(i,{modes:t=og}={})=>(e,n)=>{const s=t.map((h,u)=>{const d=new Map,p=(_,g)=>(d.has(_)||d.set(_,g(_,n)),d.get(_));return{m:h,h:1<<u,C:h.est("",n),S:h.l?(_,g)=>p(g-_,h.l):(_,g)=>p(i.slice(_,g),h.est)}});let o=[{v:0}],r=0,a=0,l=-1;for(const h of[...i,""]){let u=0;if(h)for(const d of s)d.m.test(h)&&(u|=d.h);if(!h||u!==l){if(l!==-1){const d=new Set(o.map(_=>_.D)),p=[];for(const{m:_,C:g,S:m,h:f}of s)if(l&f){const M=m(r,a);for(const S of _.eci??d)if(!_.u||!S){let x;for(const k of o)if(k.D===S||_.eci){const P=k.m===_&&k.D===S,A=P?k.V:k,I=_._&&P?k.v+M-g:A.v+12*(A.D!==S)+(P?m(P?k.$:r,a):M);(!x||I<x.v)&&(x={$:P?k.$:r,V:A,m:_,D:S,A:a,v:I})}x&&p.push(x)}}o=p}l=u,r=a}a+=h.length}o.length||xr(5);const c=[];for(let h=o.reduce((u,d)=>d.v<u.v?d:u);h.m;h=h.V)c.push(h.m(i.slice(h.$,h.A)));c.reverse().forEach(h=>h(e,n))},multi:eg,eci:ng,bytes:nu,numeric:ig,alphaNumeric:sg,ascii:qo,iso8859_1:iu,shift_jis:ou,utf8:su},h3=()=>({F:Ks(2956),I:0,push(i,t){for(let e=t,n=8-(7&this.I);e>0;e-=n,n=8)this.F[this.I>>3]|=i<<n>>e,this.I+=e<n?e:n}}),rc=(i,t=i*i,e=Ks(t))=>({size:i,K:e,get:(n,s)=>n>=0&&n<i&&!!(1&e[s*i+n]),toString({on:n="##",off:s="  ",lf:o=`
`,pad:r=4,padX:a=r,padY:l=r}={}){let c="";for(let h=-l;h<i+l;++h){for(let u=-a;u<i+a;++u)c+=this.get(u,h)?n:s;c+=o}return c},toImageData(n,{on:s=[0,0,0],off:o=[0,0,0,0],pad:r=4,padX:a=r,padY:l=r}={}){const c=i+2*a,h=i+2*l,u=n.createImageData(c,h),d=new Uint32Array(u.data.buffer);u.data.set([...s,255]);const p=d[0];u.data.set([...o,255]);const _=d[0];for(let g=0;g<h;++g)for(let m=0;m<c;++m)d[g*c+m]=this.get(m-a,g-l)?p:_;return u},toCanvas(n,s){const o=n.getContext("2d"),r=this.toImageData(o,s);n.width=r.width,n.height=r.height,o.putImageData(r,0,0)},toDataURL({type:n="image/png",scale:s=1,...o}={}){const r=document.createElement("canvas"),a=r.getContext("2d"),l=this.toImageData(a,o);return r.width=l.width*s,r.height=l.height*s,a.putImageData(l,0,0),a.imageSmoothingEnabled=!1,a.globalCompositeOperation="copy",a.drawImage(r,0,0,l.width,l.height,0,0,r.width,r.height),r.toDataURL(n,1)}}),ma=[(i,t)=>1&(i^t),(i,t)=>1&t,i=>i%3,(i,t)=>(i+t)%3,(i,t)=>1&(i/3^t>>1),(i,t)=>(i&t&1)+i*t%3,(i,t)=>(i&t)+i*t%3&1,(i,t)=>(i^t)+i*t%3&1],Ha=Ks(511);for(let i=0,t=1;i<255;t=2*t^285*(t>127))Ha[Ha[t+255]=i++]=t;const rg=i=>Ha[i%255],ag=i=>Ha[i+255],u3=(i,t)=>{const e=Ks(i.length+t.length-1);for(let n=0;n<i.length;++n)for(let s=0;s<t.length;++s)e[n+s]^=rg(i[n]+t[s]);return e.map(ag)},d3=(i,t)=>{const e=Ks(i.length+t.length-1);e.set(i,0);for(let n=0;n<i.length;++n)if(e[n]){const s=ag(e[n]);for(let o=0;o<t.length;++o)e[n+o]^=rg(t[o]+s)}return e.slice(i.length)},gh=[[0],[0,0]];for(let i=1;i<30;++i)gh.push(u3(gh[i],[0,i]));const f3=(i,t)=>{const e=[[],[]];let n=0,s=0;for(const[r,a]of t.o)for(let l=0;l<r;++l,n+=a){const c=i.slice(n,n+a);e[0].push(c),e[1].push(d3(c,gh[t.i])),s+=a+t.i}const o=Ks(s);s=0;for(const r of e)for(let a=0,l=-1;l<s;++a){l=s;for(const c of r)a<c.length&&(o[s++]=c[a])}return o},lg=(i,t,e)=>{let n=i<<=e;for(let s=134217728;s>>=1;)n&s&&(n^=t*(s>>e));return n|i},p3=({size:i,K:t},e)=>{const n=(r,a,l,c)=>{for(;l-- >0;r+=i)t.fill(c,r,r+a)},s=(r,a,l)=>{for(let c=0;c++<3;l-=2)n(a*i+r-(l>>1)*(i+1),l,l,2|c)},o=2*((i-13)/(1+(e/7|0))/2+.75|0);if(e>1)for(let r=i-7;r>8;r-=o){for(let a=r;a>8;a-=o)s(r,a,5);r<i-7&&s(r,6,5)}if(e>6)for(let r=lg(e,7973,12),a=1;a<7;++a)for(let l=12;l-- >9;r>>=1)t[a*i-l]=2|1&r;n(7,2,9,2),n(i-8,8,9,2);for(let r=0;r<i;++r)t[6*i+r]=3^1&r;s(3,3,7),s(i-4,3,7);for(let r=0;r<i;++r)for(let a=r;a<i;++a)t[a*i+r]=t[r*i+a];t[(i-8)*i+8]=3},m3=({size:i,K:t})=>{const e=[];for(let n=i-2,s=i,o=-1;n>=0;n-=2){for(n===5&&(n=4);s+=o,s!==-1&&s!==i;){const r=s*i+n;t[r+1]||e.push(r+1),t[r]||e.push(r)}o*=-1}return e},g3=({K:i},t,e)=>t.forEach((n,s)=>i[n]=e[s>>3]>>(7&~s)&1),_3=({size:i,K:t},e,n,s)=>{for(let r=0;r<i;++r)for(let a=0;a<i;++a){const l=r*i+a;t[l]^=!(e(a,r)||2&t[l])}let o=21522^lg((1^s)<<3|n,1335,10);for(let r=0;r++<8;o>>=1)t[(r-(r<7))*i+8]=1&o,t[9*i-r]=1&o;for(let r=8;--r,o;o>>=1)t[8*i+r-(r<7)]=1&o,t[(i-r)*i+8]=1&o},v3=({size:i,K:t},e=0,n=0)=>{for(let s=0;s<i;++s){for(let o=0;o<2;++o)for(let r,a=0,l=0,c=2;a<i;++a){const h=1&t[o?s*i+a:a*i+s];n+=h,l=(l>>1|2098176)&(3047517^h-1),2049&l&&(e+=40),h^c&&(r=0),c=h,e+=++r===5?3:r>5}if(s)for(let o=i+s,r=5*t[s-1]^t[s];o<i*i;o+=i){const a=5*t[o-1]^t[o];e+=3*!(1&(r|a)|4&(r^a)),r=a}}return e+10*(10*Math.abs(n/(i*i)-1)|0)},ep=[],_h=(i=xr(1),{minCorrectionLevel:t=0,maxCorrectionLevel:e=3,minVersion:n=1,maxVersion:s=40,mask:o,trailer:r=60433,...a}={})=>{e<t&&xr(3),s<n&&xr(2),typeof i=="string"&&(i=c3.auto(i,a));for(let l=n,c=0;l<=s;++l){let h=ep[l];h||(ep[l]=h=rc(4*l+17),p3(h,l),h.p=m3(h));const u=l3(l,h.p.length>>3);if(8*u(t).t<c)continue;const d=h3();i(d,l),c=d.I;for(let p=e;p>=t;--p){const _=u(p);if(8*_.t<c)continue;for(d.I=c+11&-8;d.I<8*_.t;)d.push(r,16);const g=rc(h.size,h.K);return g3(g,h.p,f3(d.F,_)),(ma[o]?[ma[o]]:ma).map((m,f)=>{const M=rc(g.size,g.K);return _3(M,m,o??f,p),M.s=ma[o]?0:v3(M),M}).reduce((m,f)=>f.s<m.s?f:m)}}xr(4)};_h.with=(...i)=>(t,e)=>_h(t,{modes:[...og,...i],...e});const dr=4;function x3(i,t){const e=_h(i,{minCorrectionLevel:Qf.M,maxCorrectionLevel:Qf.M}),n=e.size+2*dr;let s="";for(let o=0;o<e.size;o+=1)for(let r=0;r<e.size;r+=1)e.get(r,o)&&(s+=`M${r} ${o}h1v1h-1z`);return de("svg",{viewBox:`${-dr} ${-dr} ${n} ${n}`,class:"qr",role:"img","aria-label":t},de("rect",{x:-dr,y:-dr,width:n,height:n,fill:"#ffffff"}),de("path",{d:s,fill:"#000000","shape-rendering":"crispEdges"}))}class b3{root=U("div.panel-body");wall=U("div.wall");scores=U("div.table");build(){const t=U("div.column.wide");C.role==="teacher"&&t.append(U("div.row",ne(F("broadcast"),()=>C.send({kind:"Broadcast",setup:C.setup}),"broadcast",{className:"main"}),ne(F("results"),()=>S3(M3()),"results")),y3(),this.wall),t.append(this.scores),jt(this.root,t),this.update()}update(){const t=C.board?.students??[];jt(this.wall,...t.map(w3));const e=U("thead",U("tr",...["",F("name"),F("bestPush"),F("effort"),F("family")].map(s=>U("th",{scope:"col"},s)))),n=t.map((s,o)=>U("tr",{className:s.here?"":"away"},U("td",String(o+1)),U("td",s.name),U("td",ii(s.best,3)),U("td",ii(s.effort,0)),U("td",Ye(s.controller).split(":")[0])));jt(this.scores,U("table.board",{"aria-label":F("board")},e,U("tbody",...n)))}}function y3(){const i=new URL(`#token=${C.invite}`,location.href.split("#")[0]).href;return U("figure.invite",x3(i,F("invite")),U("figcaption",U("b",F("invite")),U("code",i)))}function M3(){const i=e=>`"${e.replace(/^[=+\-@\t]/,"'$&").replaceAll('"','""')}"`;return["place,name,best_push_Ns,effort_u2s,controller,here",...(C.board?.students??[]).map((e,n)=>[n+1,i(e.name),e.best.toFixed(4),e.effort.toFixed(1),i(e.controller),e.here].join(",")),""].join(`\r
`)}function S3(i){const t=URL.createObjectURL(new Blob(["\uFEFF",i],{type:"text/csv"}));U("a",{href:t,download:"results.csv"}).click(),window.setTimeout(()=>URL.revokeObjectURL(t),1e4)}function w3(i){const t=(i.pitch*180/Math.PI).toFixed(1),e=de("svg",{viewBox:"-30 -48 60 60","aria-hidden":"true"},de("rect",{x:-6,y:-40,width:12,height:38,rx:3,class:"stick",transform:`rotate(${t})`}),de("circle",{r:8,class:"wheel"}),de("line",{x1:-30,x2:30,y1:8.5,y2:8.5,class:"ground"}));return U("figure",{className:`tile${i.fallen?" down":""}${i.here?"":" away"}`},e,U("figcaption",i.name))}const Cs=["twin","nonlinear","linear"],E3=[{setup:{},lean:0,acts:[.05,.3,"size"]},{setup:{controller:"off",bodies:Cs},lean:Qa,speed:.1,ceiling:.3},{setup:{controller:"off",kit:"ideal",bodies:["nonlinear","linear"]},lean:.03,speed:.1},{setup:{controller:"lqr",bodies:Cs},lean:.1,acts:["tilt"]},{setup:{controller:"lqg",bodies:Cs},lean:0,strike:"front"},{setup:{controller:"lqg",bodies:Cs},lean:0,strike:"back",acts:["curves"]},{setup:{controller:"lqg",bodies:Cs},lean:0,strike:"front",live:!0,acts:["identify"]},{setup:{controller:"lqr",bodies:Cs,payload:.2,payload_height:.3},lean:0,acts:[.05,.3]},{setup:{controller:"robust",bodies:Cs,payload:.2,payload_height:.3},lean:0,live:!0,acts:[.05,.3,"tilt"]}],fr=E3.map((i,t)=>({scene:i,i:t})).filter(({scene:i})=>!(Qe&&i.live));class T3{constructor(t){this.tools=t}root=U("div.panel-body.tour");at=0;before=null;awaits=!1;build(){const{i:t,scene:e}=fr[this.at],{here:n,...s}=Za().tour[t],o=t===0&&!C.setup.bodies.includes("twin"),r={...s,...(Qe||o)&&n},a=(c,h,...u)=>U("div.hint-part",U("h4",c),U("p",h),...u),l=(e.acts??[]).map(c=>this.control(c));jt(this.root,U("div.column.wide",U("p.note",F("tourStep",{n:this.at+1,all:fr.length})),U("h3",r.title),U("div.hints",a(F("tourDo"),r.do,U("div.acts",...l)),a(F("tourWatch"),r.watch),a(F("tourAsk"),r.ask)),U("div.row",ne(F("previous"),()=>this.move(-1,"previous"),"tour-previous",{disabled:this.at===0}),this.at||this.before?ne(F("tourSet"),()=>this.set(),"tour-set",{className:this.at?"main":""}):null,ne(F("next"),()=>this.move(1,"next"),"tour-next",{className:this.at?"":"main",disabled:this.at===fr.length-1})),this.before?ne(F("tourBack"),()=>this.back(),"tour-back",{className:"quiet"}):null))}control(t){const{knock:e,sizer:n,tilt:s,curves:o,identify:r}=this.tools,a=`act-${t}`;if(typeof t=="number")return ne(Ih(F("mark_impulse",{size:t.toFixed(2)})),()=>e(t),a);switch(t){case"size":return n();case"tilt":return ne(F("tilt"),s,a,{title:F("tiltTip")});case"curves":return ne(F("moreCurves"),o,a);case"identify":return ne(F("tabIdentify"),r,a)}}move(t,e="set"){this.at=Math.min(Math.max(this.at+t,0),fr.length-1),this.build();const n=o=>this.root.querySelector(`[data-key=tour-${o}]:enabled`);(n(e)??n("set")??n("next"))?.focus({preventScroll:Vs.matches});const s=this.root.parentElement;s&&(s.scrollTop=0),Vs.matches&&this.upward(s?.parentElement?.querySelector(".tabs"))}upward(t){if(!t)return;const e=Math.max(...[t,document.documentElement].map((n,s)=>parseFloat(getComputedStyle(n)[s?"scrollPaddingTop":"scrollMarginTop"])||0));this.root.getBoundingClientRect().top<e+t.clientHeight&&(e?t:t.parentElement)?.scrollIntoView()}back(){this.before&&C.change(this.before),C.last.name(null),this.before=null,this.tools.run(1),C.send({kind:"StandUp",pitch:0}),this.build()}designed(){const t=this.awaits&&C.setup.controller==="robust";return this.awaits=!1,t&&C.send({kind:"StandUp",pitch:0}),t}set(){const{setup:t,lean:e,speed:n,strike:s,ceiling:o}=fr[this.at].scene;this.before||(this.before=C.setup,this.build(),this.root.querySelector("[data-key=tour-set]")?.focus()),C.anew(()=>{this.tools.run(n??1),C.change({...Hi,...t}),C.ceiling=o??null,C.send({kind:"StandUp",pitch:e})}),this.awaits=t.controller==="robust",s&&window.setTimeout(()=>C.send({kind:"Strike",what:s,size:s==="front"?.1:-.12}),1e3)}}const np=["Tour","Controller","Robot","Kit","See","Identify","Keep","Class","Python"],ip=["Tour","Controller","Robot","See","Keep","Python"],A3=.19,ac=[.01,.5],R3=10,C3=1e-6,P3={good:"info",info:"info",unknown:"info",warn:"warn",bad:"warn"},L3=1500,D3=400;function I3(){const i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info"),e=i?.getParameter(t?.UNMASKED_RENDERER_WEBGL??i.RENDERER);return i?.getExtension("WEBGL_lose_context")?.loseContext(),{able:i!==null,quick:!/swiftshader|llvmpipe|software|basic render/i.test(e)}}class N3{constructor(t){this.app=t,this.theme(is.getItem("theme")??"");const e=new URLSearchParams(location.hash.slice(1)).get("lang")??"";ud(Object.hasOwn(Dh,e)?e:is.getItem("language")??(navigator.language.startsWith("es")?"es":"en")),C.listen(n=>this.hear(n)),C.say=(n,s="info")=>this.toast(n,s),C.corrected=()=>this.toasts.querySelectorAll(".toast.error").forEach(n=>n.remove()),this.scrub.addEventListener("input",()=>C.send({kind:"Scrub",back:Number(this.scrub.max)-Number(this.scrub.value)})),this.equip(),this.measure("--toasts",this.toasts),this.measure("--fell",this.fell,8),window.addEventListener("keydown",n=>this.key(n)),window.addEventListener("hashchange",()=>C.recorded||this.link()),this.begin()}deeper=null;room=this.furnish();charts=new mA(()=>R3*this.speed);see=new QI;controller=new MR;local=null;robot=Qe?new LR(()=>this.local):new ER;python=new DR;kit=new TR;identify=new RR;keep=new CR(()=>this.picture());tour=new T3({run:t=>(this.greeted(),this.run(t)),knock:t=>(this.sizeTo(t),this.strike()),sizer:()=>this.sizer("act-size").root,tilt:()=>this.tilt(),curves:()=>this.charts.more(),identify:()=>this.bring("Identify")});classes=new b3;newcomer=!is.getItem("toured")&&!Pa(location.hash);tab=this.newcomer?"Tour":"Controller";knock=.05;sizers=[];sized=U("span.of");speed=1;scrub=U("input",{type:"range",min:"-60",max:"0",step:"0.02",value:"0",className:"scrub","data-key":"scrub"});pauseButton=U("button",{type:"button","data-key":"pause"});status=U("span.status",{role:"status"});light=U("button",{type:"button",className:"headlight","data-key":"headlight",onclick:()=>this.certificate()});force=U("div.force",{"aria-hidden":"true"});fell=U("div.fell",{role:"status"});toasts=U("div.toasts",{role:"log","aria-live":"polite"});spoken=U("p.hidden",{"aria-live":"off"});tabs=U("div.tabs",{role:"tablist"});panel=U("div.panel",{role:"tabpanel",tabIndex:-1,id:"panel"});clock=U("span.clock");state="connecting";drawn=0;down=null;lost=null;best={};most=U("span.most");telling=0;waits=0;busy=!1;prepared=!1;begun=!1;timing=!1;drawnFirst=!1;seen=0;plotted=0;said=0;shape="";steering=new r3;pinned=null;begin(){const t=Wd.inPage(),e=XT(location.hash)||(Ui.getItem("token")??"");e&&Ui.setItem("token",e),location.hash.includes("token=")&&history.replaceState(null,"",location.pathname),this.build(),Qe?(document.body.classList.add("exported"),this.local=new fR(Qe),this.link(),this.says("connected")):t?(this.says("replaying"),new Wd(t),document.body.classList.add("replay")):e&&!Ui.getItem("name")&&e.length<12?this.join(e):this.connect(e,Ui.getItem("name")??""),requestAnimationFrame(n=>this.frame(n))}connect(t,e){new NR({token:t,name:e},(n,s)=>this.says(n,s))}join(t){const e=U("input",{type:"text",id:"name",maxLength:40,required:!0,autocomplete:"name"}),n=U("dialog.join",{"aria-label":F("joinTitle")},U("form",{method:"dialog",onsubmit:s=>{s.preventDefault(),e.value.trim()&&(Ui.setItem("name",e.value.trim()),n.remove(),this.connect(t,e.value.trim()))}},U("h2",F("joinTitle")),U("label",{for:"name"},F("yourName")),e,U("button.main",F("enter"))));this.app.append(n),n.showModal()}build(){const t=U("header",U("a.skip",{href:"#panel",onclick:()=>this.panel.focus()},F("skip")),U("h1",U("span.mark",{"aria-hidden":"true"}),F("title")),U("p.what",F("what")),this.light,U("span.grow"),this.clock,this.status,Qe?IR(n=>this.toast(n,"info")):null,us("",IT,Oo(),n=>this.speak(n),"language"),ne("◐",()=>this.theme(document.documentElement.dataset.theme==="dark"?"light":"dark"),"theme",{"aria-label":F("theme"),title:F("theme")}),ne("?",()=>this.help(),"help",{"aria-label":F("help"),title:F("help")}));t.querySelector("select")?.setAttribute("aria-label","Language / Idioma");const e=U("section.scene",{"aria-label":F("scene")},this.room.element,this.force,this.fell,U("p.hint",U("span",F("hint")),this.invitation()),this.charts.slot,this.pushes(),this.transport());this.pin(e),jt(this.app,t,U("main",e,this.panels(),this.charts.root),this.toasts,this.spoken),this.lamp(),!C.snapshot&&!C.recorded&&this.tell(un(()=>F("starting"))),C.changed&&this.rebuild()}pin(t){const n={rootMargin:`1000000px 0px ${A3*innerHeight+8*parseFloat(getComputedStyle(document.documentElement).fontSize)-innerHeight}px`},s=new IntersectionObserver(o=>t.classList.toggle("pinned",o.at(-1)?.isIntersecting??!1),n);this.pinned?.disconnect(),this.pinned=s,s.observe(this.tabs)}furnish(){const t=Kp(33,o=>C.push({kind:"Drag",force:o.force,height:o.height})),e=()=>new jI(U("canvas.room",{tabIndex:0,role:"img"}),t),{able:n,quick:s}=I3();return n&&(s||!Qe)?e():(this.deeper=n?e:null,new KI(t))}measure(t,e,n=0){const s=()=>document.documentElement.style.setProperty(t,`${e.childElementCount&&e.offsetHeight+n}px`);new ResizeObserver(s).observe(e)}equip(){this.room.element.setAttribute("aria-label",F("scene")),this.room.element.addEventListener("keydown",t=>this.look(t))}deepen(){const[t,e]=[C.changed,this.room.element];!this.deeper||!t||C.snapshot?.f[0]||(this.room=this.deeper(),this.deeper=null,this.equip(),this.room.furnish(t.look,t.bodies),e.replaceWith(this.room.element),C.snapshot&&this.room.move(C.snapshot),this.room.draw?.(0))}link(){Pa(location.hash)&&this.speed!==1&&this.run(1),_R();const[t,e]=C.last.push??["",0];t==="impulse"&&e>=ac[0]&&e<=ac[1]&&this.sizeTo(e)}run(t,e=!1){this.speed=t;const n=this.app.querySelector("[data-key=speed]");n&&(n.value=String(t)),C.send({kind:"Play",paused:e,speed:t})}transport(){this.pauseButton.onclick=()=>this.pause();const t=[["0.05","× 1/20"],["0.1","× 1/10"],["0.25","× 1/4"],["0.5","× 1/2"],["1","× 1"]],e=us(F("speed"),t,String(this.speed),r=>this.run(Number(r),C.snapshot?.paused),"speed");e.querySelector("select")?.setAttribute("aria-label",F("speed"));const n=ne(F("step"),()=>C.send({kind:"Step",periods:1}),"step",{title:F("stepTip")}),s=F(C.recorded?"timeLine":"back");this.scrub.setAttribute("aria-label",s),C.recorded&&([this.scrub.min,this.scrub.max]=["0",String(C.recorded)]);const o=ne(F("standUp"),()=>this.stand(),"stand");return U("div.transport",this.pauseButton,n,o,e,U("label.scrubbing",U("span",s),this.scrub))}pushes(){const t=(o,r)=>()=>C.push({kind:"Strike",what:o,size:r}),e=()=>C.changed?.look.weight??6,n=this.sizer("knock"),s=ne(F("impulse"),()=>this.strike(),"impulse",{title:F("impulseTip"),className:"main"});return s.append(this.sized),n.root.insertBefore(this.most,n.root.lastChild),this.champion(),U("div.pushes",{role:"group","aria-label":F("pushes")},s,n.root,ne(F("front"),t("front",.1),"front",{title:F("frontTip")}),ne(F("backPush"),t("back",-.12),"back",{title:F("backTip")}),ne(F("pullLeft"),()=>t("pull_left",.25*e())(),"pull_left",{title:F("pullTip")}),ne(F("pullRight"),()=>t("pull_right",.25*e())(),"pull_right",{title:F("pullTip")}),ne(F("tilt"),()=>this.tilt(),"tilt",{title:F("tiltTip")}))}sizer(t){const[e,n]=ac,s=Ca(F("size"),{low:e,high:n,step:.01,show:o=>`${ii(o,2)} N s`,key:t},o=>this.sizeTo(o));return s.root.title=F("sizeTip"),this.sizers=[...this.sizers.filter(({root:o})=>o.isConnected),s],this.sizeTo(this.knock),s}sizeTo(t){this.knock=t;for(const e of this.sizers)e.set(t);this.sized.textContent=` ${ii(t,2)} N s`}strike(){C.push({kind:"Strike",what:"impulse",size:this.knock})}tilt(){C.send({kind:"StandUp",pitch:.1})}panels(){const t=Qe?ip:np.filter(e=>e!=="Python"&&(e!=="Class"||C.role!=="alone"));return this.tabs.setAttribute("aria-label",F("tabs")),jt(this.tabs,...t.map(e=>ne(F(`tab${e}`),()=>this.bring(e),`tab-${e}`,{role:"tab",id:`tab-${e}`,"aria-selected":String(e===this.tab),"aria-controls":"panel",tabIndex:e===this.tab?0:-1,onkeydown:n=>this.along(n,t,e)}))),U("section.below",this.tabs,this.panel)}along(t,e,n){const s={ArrowRight:1,ArrowLeft:-1}[t.key];if(!s)return;t.preventDefault(),t.stopPropagation();const o=e[(e.indexOf(n)+s+e.length)%e.length];this.open(o),document.getElementById(`tab-${o}`)?.focus()}invitation(){return this.newcomer?ne(F("newHere"),()=>this.bring("Tour"),"invitation"):null}bring(t){this.open(t),Vs.matches&&this.tabs.scrollIntoView(),document.getElementById(`tab-${t}`)?.scrollIntoView({block:"nearest",inline:"center"})}certificate(){this.open("Controller"),this.panel.querySelector(".light h4")?.scrollIntoView({block:Vs.matches?"start":"center"})}greeted(){this.newcomer=!1,is.setItem("toured","yes"),this.app.querySelector("[data-key=invitation]")?.remove()}open(t){this.tab=t,this.greeted();for(const e of this.tabs.querySelectorAll("[role=tab]")){const n=e.id===`tab-${t}`;e.setAttribute("aria-selected",String(n)),e.tabIndex=n?0:-1}this.panel.setAttribute("aria-labelledby",`tab-${t}`),this.fill()}fill(){if(!C.catalogue||!C.changed)return;const t=this.opened();zs(()=>{t.build(),jt(this.panel,t.root)})}opened(){return{Controller:this.controller,Robot:this.robot,Kit:this.kit,See:this.see,Identify:this.identify,Keep:this.keep,Tour:this.tour,Class:this.classes,Python:this.python}[this.tab]}rebuild(){this.shape="",this.follow(),this.fill(),this.lamp()}follow(){const t=C.changed;if(!t)return;const e=JSON.stringify([t.bodies,t.look]);e!==this.shape&&(this.shape=e,this.room.furnish(t.look,t.bodies),this.charts.build())}hear(t){switch(t.kind){case"Welcome":this.timing=!Qe&&!C.recorded,zs(()=>this.build());break;case"Catalogue":this.fill();break;case"Changed":{const e=!this.panel.firstChild;this.follow(),!this.begun&&!Qe&&this.link(),this.begun=!0,e?this.fill():this.opened().update?.(),this.lamp(),this.champion(),this.identify.changed();const n=this.busy&&!t.busy;this.prepared=n&&this.tour.designed(),t.busy!==this.busy&&this.rest();break}case"Analysed":case"Light":this.lamp(),this.opened().update?.();break;case"Equations":this.tab==="See"&&this.see.update();break;case"Snapshot":this.transported();break;case"Progress":if(t.job==="light"){this.lamp(),this.opened().update?.();break}this.identify.progress(t.job,t.fraction),t.job==="certify"&&this.controller.certifying(t.fraction);break;case"JobResult":this.identify.found(),t===C.certified&&this.controller.certify(),(t!==C.certified||this.tab!=="Controller")&&this.toast(()=>`${Ye(t.job)} – ${Gi(t.heads).verdict}`,P3[t.heads.en.level]),Ns&&this.tab==="Identify"&&zs(()=>this.identify.build());break;case"Made":if(t.name===Tc){this.compared(C.files+t.url);break}this.keep.made(t.name,t.url.startsWith("blob:")?t.url:C.files+t.url),this.toast(()=>F("made",{name:t.name}),"info");break;case"Notice":t.key==="lies"?this.lie(()=>F("lies")):t.job?this.failed(t):this.toast(()=>t.key?Ye(t.key):Mr(t.parts),t.level);break;case"Recovered":this.recovered(t);break;case"Board":this.tab==="Class"&&this.classes.update();break}}lamp(){const t=gm();if(this.app.classList.toggle("loose",C.falls||(C.changed?.busy??!1)),C.recorded&&(C.lit?.light??"none")==="none")return jt(this.light);this.light.title=`${Ih(Ec())}. ${F("lightNote")}`,jt(this.light,U("span",{className:`lamp ${t}`,"aria-hidden":"true"}),U("span.word",{"aria-hidden":"true"},t==="none"?"…":F(t)),U("span",`${F("certificate")}:`),U("span",Ec(!0)))}recovered({impulse:t,fell:e,single:n}){const s=this.driven(),o=this.best[s]??0,r=Math.max(o,n&&!e?t:0);this.prepared=!1,r&&(this.best[s]=r),this.champion();const a=()=>({impulse:fe(t),best:fe(r)});if(e&&(this.lost=()=>F(n?"lostPush":"lostPushes",a())),this.down)return this.lie();e||(this.tell(un(()=>F(n?r<o*(1+C3)?"recovered":"recoveredMost":"recoveredSeveral",a()))),this.telling=window.setTimeout(()=>this.rest(),6e3))}compared(t){this.identify.compared(t),this.tab!=="Identify"&&this.toast(()=>F("comparedThere"),"info")}failed({job:t,parts:e,level:n}){const s=t.startsWith("keep compar")?"compare":t,o=["doctor","calibrate","compare"].includes(s),r=()=>o||t==="certify"?F("jobStopped",{job:Ye(s),why:Mr(e)}):Mr(e),a=()=>e.en?r():F("wasStopped",{job:Ye(s)});o&&e.en&&this.identify.fail(a,e.en.verb),(!o||!e.en||this.tab!=="Identify")&&this.toast(a,n)}driven(){return`${C.setup.robot} ${C.setup.controller}`}champion(){const t=this.best[this.driven()];this.most.textContent=t?F("best",{best:fe(t)}):"",this.most.title=F("bestTip")}tell(...t){window.clearTimeout(this.telling),jt(this.fell,...t)}rest(){this.busy=C.changed?.busy??!1,!this.down&&this.tell((this.busy||this.prepared)&&un(()=>this.busy?dm():F("designed")))}lie(t=this.lost??(()=>F("fallen"))){const e=U("button",{type:"button",className:"main",onclick:()=>this.stand()},un(()=>F("standUp")));this.tell(un(t),!C.recorded&&e)}transported(){const t=C.snapshot;if(!t)return;this.timing&&C.send({kind:"Play",paused:t.paused,speed:this.speed}),this.timing=!1;const e=t.paused?F("play"):F("pause");this.pauseButton.textContent!==e&&(this.pauseButton.textContent=e),C.recorded?this.timed(t.t):document.activeElement!==this.scrub&&(this.scrub.min=String(-Math.min(Math.max(Math.ceil(t.t+t.back-(C.traces.t[0]??t.t)),1),60)),this.scrub.value=String(-t.back)),this.clock.textContent=`${ii(t.t,1)} ${C.recorded?`/ ${ii(C.recorded,1)} `:""}s`;const n=!!t.x[0][8];n!==this.down&&(n||(this.lost=null),this.down=n,n?this.lie():this.rest(),this.app.querySelector("[data-key=impulse]")?.classList.toggle("main",!n));const s=t.f[0],o=t.f[2]?`${F("slope")}: ${kh(t.f[2])}`:"";C.traces.marks.some(({what:r})=>!xc.includes(r))&&this.app.classList.add("pushed"),this.force.textContent=Math.abs(s)>.005?F("newtons",{force:ii(s,2)}):o,this.force.classList.toggle("slope",!(Math.abs(s)>.005))}timed(t){this.scrub.matches(":active")||(this.scrub.value=String(t)),this.scrub.setAttribute("aria-valuetext",`${ii(t,1)} s`)}seek(t){const[e,n]=[C.snapshot,C.recorded||60],s=(C.recorded?C.recorded-(e?.t??0):e?.back??0)-t;C.send({kind:"Scrub",back:Math.max(0,Math.min(n,s))})}stand(){C.send({kind:"StandUp",pitch:C.falls?Qa:0}),C.send({kind:"Play",paused:!1,speed:this.speed})}pause(){C.send({kind:"Play",paused:!C.snapshot?.paused,speed:this.speed})}says(t,e=()=>""){t==="lost"&&this.state!=="lost"&&(this.waits=window.setTimeout(()=>this.tell(un(()=>F("gone"))),L3)),t==="connected"&&this.state==="lost"&&this.back(),this.state=t,this.status.className=`status ${t}`,this.status.textContent=F(t),t==="refused"&&(Ui.removeItem("name"),jt(this.app,U("main.refused",{role:"alert"},U("h1",F("refused")),U("p",e()),ne("↻",()=>location.reload(),"reload"))))}back(){window.clearTimeout(this.waits),this.down?this.lie():this.rest()}toast(t,e){if(this.toasts.lastElementChild?.firstElementChild?.textContent===t())return;const n=U("button",{type:"button",onclick:()=>s.remove()},U("span",{"aria-hidden":"true"},"×"),U("span.hidden",un(()=>F("close")))),s=U("div",{className:`toast ${e}`},un(t),n);this.toasts.querySelectorAll(e==="error"?".toast.error":".toast:not(.error)").forEach(o=>o.remove()),this.toasts.append(s),window.setTimeout(()=>s.remove(),e==="error"?15e3:6e3)}speak(t){ud(t),is.setItem("language",t),this.build(),this.says(this.state),Nh(this.app),this.describe(),this.app.querySelector("[data-key=language]")?.focus()}theme(t){const e=t?t==="dark":matchMedia("(prefers-color-scheme: dark)").matches;document.documentElement.dataset.theme=e?"dark":"light",t&&is.setItem("theme",t),this.room.paint?.(),C.changed&&this.charts.build(),this.panel.firstChild&&this.fill()}help(){const t=["impulse","size","front","back","pull","tilt","step"].map(h=>[F(h==="pull"?"pullBoth":h==="back"?"backPush":h),F(`${h}Tip`)]),[e,n,s,...o]=Za().keys,a=(matchMedia("(hover: none)").matches?[s,...t]:[...t,e,n,s,...o]).map(([h,u])=>U("tr",U("th",{scope:"row"},h),U("td",u))),l=U("h2",{tabIndex:-1},F("help")),c=U("dialog.help",{"aria-label":F("help"),onclose:()=>c.remove()},l,U("table",U("tbody",...a)),U("div.foot",ne(F("close"),()=>c.close(),"close",{className:"main"})));this.app.append(c),c.showModal(),l.focus(),c.scrollTop=0}key(t){if(!(vc(t,"input, select, textarea, dialog")||t.key===" "&&vc(t,"button, summary"))){if(t.key==="?")this.help();else if(t.key===" ")this.pause();else if(t.key===".")C.send({kind:"Step",periods:1});else if(t.key===","||t.key==="/")this.seek(t.key===","?-.25:.25);else if(t.key==="s")this.stand();else if(t.key==="n"||t.key==="p")this.toured(t.key==="n"?1:-1);else if(t.key==="k")this.strike();else if(/^[1-8]$/.test(t.key)&&document.getElementById(`tab-${this.tabAt(t.key)}`))this.open(this.tabAt(t.key));else return;t.preventDefault()}}tabAt(t){return(Qe?ip:np)[Number(t)-1]}toured(t){const e=this.tab==="Tour";e||this.open("Tour"),this.tour.move(e?t:0)}look(t){const e={"[":[-.15,0],"]":[.15,0],"{":[0,-.1],"}":[0,.1]};t.key in e&&this.room.turn?.(...e[t.key]),t.key==="+"&&this.room.zoom?.(.9),t.key==="-"&&this.room.zoom?.(1.1)}frame(t){C.snapshot&&this.room.move(C.snapshot),this.room.draw?.(t-this.drawn),this.drawnFirst&&t>this.seen+D3?this.deepen():C.snapshot&&!this.drawnFirst&&([this.drawnFirst,this.seen]=[!0,t]),this.drawn=t,t-this.plotted>45&&(this.charts.draw(),this.tab==="See"&&this.see.draw(),this.plotted=t),t-this.said>2e3&&(this.describe(),this.said=t),this.steering.tick(t),requestAnimationFrame(e=>this.frame(e))}describe(){const[t,e]=[C.snapshot,C.changed];if(!t||!e)return;const n=Ye(e.bodies[0]),s=ii(e.look.wheel_radius*t.x[0][2]*100,0),o=t.x[0][8]?F("fellNow",{body:n}):F("sceneNow",{body:n,pitch:ii(t.x[0][0]*180/Math.PI,1),way:s});this.spoken.textContent=o,this.room.element.setAttribute("aria-label",`${F("scene")} ${o}`)}picture(){return this.room.picture([C.setup.robot,Ye(C.setup.controller),`${ii(C.snapshot?.t??0,1)} s`,"upright lab"].join("  ·  "))}address(){return Hh()}grasp(){return this.room.grasp()}}const U3=new N3(document.getElementById("app"));Object.assign(window,{upright:{store:C,page:U3,exported:Qe}});
